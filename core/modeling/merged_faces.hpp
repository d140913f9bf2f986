#pragma once

// Triangles in one plane merged on the way to the surface; the designer's polyhedron keeps them (kuriyama.md
// section 11).

#include <memory>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/source.hpp"
#include "core/polyhedron/element_aliases.hpp"

namespace hariko {

/// After triangles in one plane were merged no edge leads to the vertex, so that the surface does not meet
/// it.
inline constexpr Code w_vertex_merged{"W_VERTEX_MERGED"};

/// A polyhedron and the same with triangles in one plane merged.
struct MergedFaces {
  PolyhedronSource before;
  /// Faces that each merged face is made of, by dense indices, the one that stands for it first; and its
  /// corners.
  struct Group {
    std::vector<Index> faces;
    std::vector<Index> corners;
    friend bool operator==(const Group&, const Group&) = default;
  };
  std::vector<Group> groups;                      ///< ascending by first face
  std::vector<VertexId> lost;                     ///< vertices that no edge leads to any more, ascending
  PolyhedronSource source;                        ///< a merged face has the least id of its faces
  std::shared_ptr<const ElementAliases> aliases;  ///< null when nothing was merged
};

/// Edges between triangles whose normals differ by at most 1e-6 rad go, where what is left is one polygon
/// without holes of at most as many sides as the mode takes. (Faces of more sides were meant: an edge loop in
/// a flat side holds the surface.) Edges with a crease or a tension of their own stay, and so do those at
/// vertices with pinned tangents, or with any setting where the vertex would lose all its edges. A function
/// of the polyhedron alone: `previous` spares work while connectivity and groups stay the same. O(corners log
/// n), more where many triangles in one plane go round holes.
Result<MergedFaces> with_merged_faces(const PolyhedronSource& source, const MergedFaces* previous = nullptr);

/// W_VERTEX_MERGED, 100 at the most; none unless the source merges faces.
std::vector<Message> merge_warnings_of(const PolyhedronSource& source);

}  // namespace hariko

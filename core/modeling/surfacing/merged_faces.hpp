#pragma once

// Merging of coplanar triangles in the preparation of the surface; the designer's polyhedron keeps them
// (kuriyama.md section 11).

#include <memory>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/source.hpp"
#include "core/polyhedron/element_aliases.hpp"

namespace hariko {

/// Warning: after coplanar triangles were merged no edge leads to the vertex, so that the surface does not
/// pass through it.
inline constexpr Code w_vertex_merged{"W_VERTEX_MERGED"};

/// A polyhedron before and after its coplanar triangles were merged.
struct MergedFaces {
  PolyhedronSource before;
  /// Dense indices of the faces that a merged face consists of, the one whose id it keeps first; and its
  /// corners.
  struct Group {
    std::vector<Index> faces;
    std::vector<Index> corners;
    friend bool operator==(const Group&, const Group&) = default;
  };
  std::vector<Group> groups;                      ///< ascending by first face
  std::vector<VertexId> lost;                     ///< vertices that no edge leads to any more, ascending
  PolyhedronSource source;                        ///< a merged face has the lowest id of its faces
  std::shared_ptr<const ElementAliases> aliases;  ///< null when nothing was merged
};

/// Merges triangles whose normals differ by at most 1e-6 rad, where the union is one polygon without holes
/// whose number of sides the mode allows. (Faces of more sides are kept as modelled: an edge loop in a flat
/// side stabilises the surface.) Edges with a crease or a tension of their own stay, and so do those at
/// vertices with pinned tangents, or with any setting where the vertex would lose all its edges. The result
/// depends on the polyhedron alone: `previous` saves work while connectivity and groups stay the same.
/// O(corners log n), more where many coplanar triangles surround holes.
Result<MergedFaces> with_merged_faces(const PolyhedronSource& source, const MergedFaces* previous = nullptr);

/// Returns W_VERTEX_MERGED messages, at most 100; none unless the source merges faces.
std::vector<Message> merge_warnings_of(const PolyhedronSource& source);

}  // namespace hariko

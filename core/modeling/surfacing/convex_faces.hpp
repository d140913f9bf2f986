#pragma once

// Convex decomposition of concave faces in the preparation of the surface; the designer's polyhedron keeps
// its faces (kuriyama.md section 11).

#include <memory>
#include <optional>
#include <vector>

#include "core/document/source.hpp"
#include "core/polyhedron/element_aliases.hpp"

namespace hariko {

/// Decomposition of one face: its dense index, and the corner numbers of its pieces; the first piece holds
/// corner 0.
struct FaceCut {
  Index face = no_index;
  std::vector<std::vector<Index>> pieces;
  friend bool operator==(const FaceCut&, const FaceCut&) = default;
};

/// A polyhedron before and after the decomposition of its concave faces.
struct ConvexFaces {
  PolyhedronSource before;
  std::vector<Index> concave;  ///< concave faces, ascending, including those that could not be cut
  std::vector<FaceCut> cuts;   ///< ascending by face; empty when no face was cut
  PolyhedronSource source;     ///< the first piece of a face keeps its id, the others get the next free ids
  std::shared_ptr<const ElementAliases> aliases;  ///< null when nothing was cut
};

/// Cuts concave faces into convex pieces without new vertices; inner edges are smooth and have tension 1.
/// Faces whose projection intersects itself, or where every possible cut is already an edge of the
/// polyhedron, stay as they are (`face_shape_warnings_of` names the former). The result depends on the
/// polyhedron alone: `previous`, made from the same connectivity, saves the test of convex faces that did not
/// move; while the cuts and the shaping stay the same the result shares its topology. O(corners), and O(n^2)
/// for a concave face of n sides.
Result<ConvexFaces> with_convex_faces(const PolyhedronSource& source, const ConvexFaces* previous = nullptr);

}  // namespace hariko

#pragma once

// Concave faces cut into convex ones on the way to the surface; the designer's polyhedron keeps them
// (kuriyama.md section 11).

#include <memory>
#include <optional>
#include <vector>

#include "core/document/source.hpp"
#include "core/polyhedron/element_aliases.hpp"

namespace hariko {

/// A face, by its dense index, and the corner numbers of its pieces; the first piece holds corner 0.
struct FaceCut {
  Index face = no_index;
  std::vector<std::vector<Index>> pieces;
  friend bool operator==(const FaceCut&, const FaceCut&) = default;
};

/// A polyhedron and the same with its concave faces cut.
struct ConvexFaces {
  PolyhedronSource before;
  std::vector<Index> concave;  ///< the concave faces, ascending, whether they could be cut or not
  std::vector<FaceCut> cuts;   ///< ascending by face; empty when no face is concave
  PolyhedronSource source;     ///< the first piece of a face keeps its id, the others get the next free ones
  std::shared_ptr<const ElementAliases> aliases;  ///< null when nothing was cut
};

/// Without new vertices; inner edges are smooth and have tension 1. Faces whose projection crosses itself, or
/// whose corners are joined by other faces' edges so that no cut is left, stay as they are
/// (`face_shape_warnings_of` names the former). A function of the polyhedron alone: `previous`, made from the
/// same connectivity, spares looking at convex faces that did not move; while the cuts and the shaping stay
/// the same the result shares its topology. O(corners), and O(n^2) for a concave face of n sides.
Result<ConvexFaces> with_convex_faces(const PolyhedronSource& source, const ConvexFaces* previous = nullptr);

}  // namespace hariko

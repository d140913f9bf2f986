#pragma once

// Repairs of polygon meshes that validation offers. Each returns a new mesh and leaves positions of kept
// vertices alone.

#include <optional>
#include <vector>

#include "core/base/result.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Makes neighbouring faces agree in orientation (flood fill over edges shared by two faces), then turns
/// closed components outward (positive signed volume), but cavities, which lie in another component and look
/// the other way, inward. Fails with E_EDGE_NONMANIFOLD_OR_FLIPPED where no
/// consistent orientation exists (a one-sided surface) or an edge has more than two faces.
Result<PolygonMesh> repair_orientation(const PolygonMesh& mesh);

/// Orients faces as far as possible: edges with more than two faces count as boundary, and a one-sided
/// surface stays cut where it would close. Parts are turned outward where they are closed and neither of
/// these occurred.
PolygonMesh orient_where_possible(const PolygonMesh& mesh);

/// Cuts the mesh open along edges with more than two faces, or used twice in one direction, by duplicating
/// vertices.
PolygonMesh split_nonmanifold_edges(const PolygonMesh& mesh);

/// Gives every fan at a vertex that has several its own copy of the vertex.
PolygonMesh split_nonmanifold_vertices(const PolygonMesh& mesh);

/// Mesh with vertices of their own for bodies that touched. Copies of vertices stand behind all others.
struct SeparatedBodies {
  PolygonMesh mesh;
  std::vector<Index> original;  ///< vertex of the input, per vertex
};

/// Separates bodies that touch along edges or in points, where this makes the whole mesh manifold and leaves
/// nothing open: at edges with more than two faces the two sides are paired that ordinary edges connect to
/// one body, and the others with their neighbours in angle, the inside between them, where that makes closed
/// bodies that are no two sides of a sheet; where a body touches itself so that the edge would remain one,
/// the outside between them. Nothing where there is nothing to separate, or that is impossible. O(corners)
/// expected, times the edges with more than two faces at a vertex.
std::optional<SeparatedBodies> separate_bodies(const PolygonMesh& mesh);

/// Pairs sides as `separate_bodies` does wherever it is possible, and gives the others at edges with more
/// than two faces borders of their own.
SeparatedBodies separate_at_edges(const PolygonMesh& mesh);

/// Mesh after `cut_keyholes`.
struct CutKeyholes {
  PolygonMesh mesh;
  std::size_t cut = 0;  ///< faces that were cut
};
/// Cuts faces with a hole that is joined to the rim by sides walked in both directions (keyholes) into convex
/// faces that cover the face and not the hole. Faces stay as they are where they come back to a vertex
/// otherwise, or cannot be cut exactly. O(corners) without such faces.
CutKeyholes cut_keyholes(PolygonMesh mesh);

/// Removes vertices that no face uses.
PolygonMesh remove_isolated_vertices(const PolygonMesh& mesh);

/// Splits faces that return to a vertex into several, one for each loop.
PolygonMesh split_repeated_corners(const PolygonMesh& mesh);

/// Merges vertices closer than `distance` (in the mesh's unit, >= 0; 0 merges equal positions only). Faces
/// that lose corners shrink; those left with fewer than three are dropped.
PolygonMesh weld(const PolygonMesh& mesh, double distance);

/// Statistics of `make_manifold`.
struct RepairReport {
  std::size_t merged_vertices = 0;  ///< merged into others at nearly the same position
  /// degenerate, double, or with vertices that do not exist; of split faces the parts count
  std::size_t dropped_faces = 0;
  std::size_t turned_faces = 0;      ///< turned to agree with their neighbours
  std::size_t cut_faces = 0;         ///< with a hole, or back at one of their corners: cut into several
  std::size_t split_vertices = 0;    ///< copies added where the mesh was cut apart
  std::size_t removed_vertices = 0;  ///< vertices used by no face
  friend bool operator==(const RepairReport&, const RepairReport&) = default;
};

/// Mesh after `make_manifold`, with its statistics.
struct Repaired {
  PolygonMesh mesh;
  RepairReport report;
};

/// Makes a mesh manifold by all of these repairs in turn, so that `Polyhedron::build` accepts the result:
/// vertices nearer than `joining_distance` are merged, unusable faces dropped, the others oriented, faces
/// with holes cut, bodies that touch separated, and parts that are still not manifold cut apart. A manifold
/// mesh without near vertices is returned unchanged except for unused vertices. Errors: E_NO_FACES when no
/// face is left, E_NONFINITE when a used position is not finite.
Result<Repaired> make_manifold(const PolygonMesh& mesh);

}  // namespace hariko

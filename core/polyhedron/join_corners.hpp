#pragma once

// Faults of files of other programs: corners of neighbouring faces that are not joined, and triangles without
// area.

#include <vector>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// A mesh that was made tidy.
struct TidyMesh {
  PolygonMesh mesh;
  std::vector<Index> vertex_of;  ///< of each vertex before, its number now
  std::size_t joined = 0;        ///< vertices that went into others
  double farthest = 0;           ///< of them, from where they were
  std::size_t collapsed = 0;     ///< faces that were left with fewer than three corners, and dropped
  std::size_t flat = 0;          ///< triangles along an edge that were dropped or turned
};

/// Part of the size that near corners are apart at most where nothing else is said.
inline constexpr double usual_joining_distance = 1e-6;

/// Length of the diagonal of the box round the vertices that faces use.
double used_size(const PolygonMesh& mesh);

/// Joins vertices on borders that are at most `distance` apart (>= 0; 0: equal ones). Vertices round which
/// faces already close stay as they are, so bodies that touch are not joined, nor are fans that touch in a
/// point only. Where joining makes more than two faces meet at an edge, or faces look against each other,
/// and the mesh was sound without it, nothing is joined, unless none of its faces had a neighbour: then it is
/// said by what follows (`validate`). Faces lose corners that became the same. O(corners) expected.
TidyMesh join_corners(const PolygonMesh& mesh, double distance);

/// How many vertices `join_corners` would join, and how far they are apart.
struct NearCorners {
  std::size_t count = 0;
  double farthest = 0;
};
NearCorners near_corners(const PolygonMesh& mesh, double distance);

/// Drops triangles whose three corners lie on a line (nearer than 1e-6 of their longest side) where the other
/// faces at their edges fit together without them, and turns those that fill the gap of a T-joint, so that
/// the face across their longest side gets their middle corner. Expected O(corners + flat triangles^2 at
/// worst).
TidyMesh drop_flat_triangles(const PolygonMesh& mesh);

}  // namespace hariko

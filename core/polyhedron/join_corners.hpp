#pragma once

// Repair of typical faults in imported files: corners of neighbouring faces that are not joined, and
// triangles without area.

#include <vector>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Mesh after a repair, with a record of the changes.
struct TidyMesh {
  PolygonMesh mesh;
  std::vector<Index> vertex_of;  ///< new number of each vertex of the input
  std::size_t joined = 0;        ///< vertices that were merged into others
  double farthest = 0;           ///< greatest distance that one of them was moved
  std::size_t collapsed = 0;     ///< faces left with fewer than three corners, dropped
  std::size_t flat = 0;          ///< triangles along an edge that were dropped or turned
  std::size_t keyholes = 0;      ///< faces with a hole that were cut
};

/// Default joining distance, relative to the size of the mesh.
inline constexpr double usual_joining_distance = 1e-6;
/// Distance within which corners of faces that are all loose probably belong together, relative to the size.
inline constexpr double loose_joining_distance = 1e-3;

/// Size of a mesh: the diagonal of the bounding box of the vertices that faces use.
double used_size(const PolygonMesh& mesh);
/// Median length of the sides of faces, of those that have a length; of many sides a sample. 0 where there is
/// none. O(corners).
double median_side(const PolygonMesh& mesh);
/// Joining distance of a mesh where none is chosen: `usual_joining_distance` of its size, but at most a tenth
/// of the median side, as stray parts far away make the size large.
double joining_distance(const PolygonMesh& mesh);

/// Joins vertices on open boundaries that are at most `distance` apart (a length >= 0; 0 joins equal
/// positions). Vertices round which faces already close stay as they are, so bodies that touch are not
/// joined, nor are fans that touch in a point only. Where joining would make more than two faces meet at an
/// edge or neighbours disagree in orientation, although the mesh was sound before, nothing is joined, unless
/// no face had a neighbour: then `validate`, which follows, reports the faults. Corners that became equal are
/// removed from faces. O(corners) expected.
TidyMesh join_corners(const PolygonMesh& mesh, double distance);

/// Number of vertices that `join_corners` would join, and their greatest distance.
struct NearCorners {
  std::size_t count = 0;
  double farthest = 0;
};
/// Counts the vertices that `join_corners` would join, without joining them. O(corners) expected.
NearCorners near_corners(const PolygonMesh& mesh, double distance);

/// Drops flat triangles, whose three corners lie on a line (nearer than 1e-6 of their longest side), where
/// the other faces at their edges fit together without them, and turns those that fill the gap of a T-joint,
/// so that the face across their longest side gets their middle corner. O(corners) expected, plus O(flat
/// triangles^2) at worst.
TidyMesh drop_flat_triangles(const PolygonMesh& mesh);

}  // namespace hariko

#pragma once

// Triangulation of polygons in space.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Triangulates a polygon over its own corners (indices into `corners`), with the same orientation: ear
/// clipping in the projection along the polygon's mean normal, so concave faces are right where that
/// projection does not intersect itself. Always corners - 2 triangles. O(n^2), above 1000 corners about
/// O(n^1.5); a rest without ears becomes a fan.
std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const Vector3> corners);

/// Triangles of all faces of a mesh, and the face of each triangle. Faces with fewer than three corners have
/// none; indices must be in range.
struct FaceTriangles {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> faces;
};
/// Triangulates all faces of a mesh by `triangulate_polygon`.
FaceTriangles triangulate(const PolygonMesh& mesh);

}  // namespace hariko

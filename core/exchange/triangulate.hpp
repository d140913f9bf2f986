#pragma once

// Triangles of a polygon in space.

#include <array>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Triangles over the polygon's own corners (numbers into `corners`), same orientation: ears cut off in the
/// projection along the polygon's mean normal, so concave faces are right when that projection does not cross
/// itself. Always corners - 2 triangles. O(n^2), above 1000 corners O(n * corners that bend inward); what has
/// no ear left is cut as a fan.
std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const Vector3> corners);

/// All faces of a mesh as triangles, and the face that each is of. Faces with fewer than three corners have
/// none; indices must be in range.
struct FaceTriangles {
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> faces;
};
FaceTriangles triangulate(const PolygonMesh& mesh);

}  // namespace hariko

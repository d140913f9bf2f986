#pragma once

// Triangles whose vertices have one normal each, as most formats and graphics cards want them.

#include <array>
#include <vector>

#include "core/surface/tessellation.hpp"

namespace hariko {

/// Positions are relative to the origin of the mesh that it was made from.
struct VertexTriangles {
  std::vector<Vector3> positions;
  std::vector<Vector3> normals;  ///< one for each position, or none
  std::vector<std::array<Index, 3>> triangles;
};

/// A position with several normals becomes several vertices, each pair in use one; in the order of first use.
/// Meshes without normals keep their positions as they are. O(size).
VertexTriangles with_single_normals(const TriangleMesh& mesh);

}  // namespace hariko

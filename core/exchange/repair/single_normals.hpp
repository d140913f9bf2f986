#pragma once

// Triangles with one normal for each vertex, as most formats and graphics cards need them.

#include <array>
#include <vector>

#include "core/surface/tessellation.hpp"

namespace hariko {

/// Triangles with vertex normals. Positions are relative to the origin of the source mesh.
struct VertexTriangles {
  std::vector<Vector3> positions;
  std::vector<Vector3> normals;  ///< one for each position, or none at all
  std::vector<std::array<Index, 3>> triangles;
};

/// Splits positions with several normals: each pair of position and normal in use becomes a vertex, in the
/// order of first use. Meshes without normals keep their positions. O(size).
VertexTriangles with_single_normals(const TriangleMesh& mesh);

}  // namespace hariko

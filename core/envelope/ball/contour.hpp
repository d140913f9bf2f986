#pragma once

// Dual marching cubes over cubes of several sizes: closed manifold meshes of triangles and quads at a field's
// zero surface (docs/envelope.md).

#include "core/envelope/ball/cube_tree.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Vertex of a contour, in one cube.
struct ContourVertex {
  Cube cube;
  Vector3 position = Vector3::Zero();  ///< mean of the points where the surface crosses the cube's edges
  /// Number of faces at the vertex; two where the surface crosses only one split edge of its cube.
  int faces = 0;
};

/// Mesh made by dual marching cubes.
struct Contour {
  std::vector<ContourVertex> vertices;
  /// Counter-clockwise seen from outside; triangles end with no_index.
  std::vector<std::array<Index, 4>> faces;
};

/// Makes the contour of a field that is negative inside, 1-Lipschitz, and positive on the boundary of the
/// box. Each edge of the result is used by two faces, each vertex by one fan. O(cubes of the box).
Contour contour(const CubeTree& cubes, const SplineField& field);

}  // namespace hariko

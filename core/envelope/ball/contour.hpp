#pragma once

// Closed manifold meshes of triangles and quads where a field changes its sign: dual marching cubes over
// cubes of several sizes (docs/envelope.md).

#include "core/envelope/ball/cube_tree.hpp"
#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

struct ContourVertex {
  Cube cube;
  Vector3 position = Vector3::Zero();  ///< mean of the places where the surface crosses the cube's edges
  int faces = 0;                       ///< about it: two where all it crosses of its cube is one halved edge
};

struct Contour {
  std::vector<ContourVertex> vertices;
  /// Counter-clockwise seen from outside; triangles end with no_index.
  std::vector<std::array<Index, 4>> faces;
};

/// The field is negative inside, changes by no more than the way, and is positive all round the box. Each
/// edge of the result is used by two faces, each vertex by one fan. O(cubes of the box).
Contour contour(const CubeTree& cubes, const SplineField& field);

}  // namespace hariko

#pragma once

// Closed manifold meshes of quads from inside flags: dual marching cubes (docs/envelope.md, spec 16.5).

#include <functional>
#include <vector>

#include "core/envelope/field_grid.hpp"

namespace hariko {

struct ContourVertex {
  std::array<int, 3> cell;
  /// Grid edges that the surface crosses: lower node and axis.
  std::vector<std::array<int, 4>> crossings;
};

struct Contour {
  std::vector<ContourVertex> vertices;
  std::vector<std::array<Index, 4>> quads;  ///< counter-clockwise seen from outside
};

/// The outermost nodes must be outside. `inside` decides where a face of a cell can be cut in two ways: is
/// its centre inside? Each edge of the result is used by two quads, each vertex by one fan, of at least
/// three.
Contour contour(const FlagGrid& grid, const std::function<bool(const Vector3&)>& inside);

/// Of the mesh itself: where faces of cells were cut in the other way it differs from that of the flags.
GridTopology topology_of(const Contour& contour);

}  // namespace hariko

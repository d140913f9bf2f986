#pragma once

// Closed manifold meshes of quads from inside flags: dual marching cubes (docs/envelope.md).

#include <array>
#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Nodes at planes along three axes; flags say which are inside.
struct FlagGrid {
  std::array<std::vector<double>, 3> planes;
  std::vector<char> inside;

  std::array<int, 3> size() const {
    return {int(planes[0].size()), int(planes[1].size()), int(planes[2].size())};
  }
  std::size_t index(int i, int j, int k) const {
    return (std::size_t(k) * planes[1].size() + std::size_t(j)) * planes[0].size() + std::size_t(i);
  }
  Vector3 point(int i, int j, int k) const {
    return {planes[0][std::size_t(i)], planes[1][std::size_t(j)], planes[2][std::size_t(k)]};
  }
};

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

}  // namespace hariko

#include "core/envelope/ball/cube_tree.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

void CubeTree::split(const Cube& cube) {
  if (cube.level >= depth_ || !holds(cube) || is_split(cube)) return;
  if (cube.level > 0) {
    // Its neighbours of the level above have to be split, as its parent is; the parent is one of them.
    for (int c = 0; c < 27; ++c) {
      Cube beside = cube;
      const std::array<int, 3> by{c % 3 - 1, c / 3 % 3 - 1, c / 9 - 1};
      for (std::size_t a = 0; a < 3; ++a) beside.at[a] += by[a];
      if (!holds(beside)) continue;
      split({cube.level - 1, {beside.at[0] >> 1, beside.at[1] >> 1, beside.at[2] >> 1}});
    }
  }
  split_.insert(key(cube));
}

Cube CubeTree::leaf(const std::array<int, 3>& steps) const {
  Cube out;
  for (;; ++out.level) {
    const int shift = depth_ - out.level;
    out.at = {steps[0] >> shift, steps[1] >> shift, steps[2] >> shift};
    if (!is_split(out)) return out;
  }
}

Cube CubeTree::leaf_at(const Vector3& point) const {
  std::array<int, 3> steps;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = Eigen::Index(a);
    const double at = std::floor((point[axis] - low_[axis]) / edge(depth_));
    steps[a] = int(std::clamp(at, 0.0, double((size_[a] << depth_) - 1)));
  }
  return leaf(steps);
}

}  // namespace hariko

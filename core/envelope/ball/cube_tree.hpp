#pragma once

// CubeTree: balanced octree of cubes, split where details are small (docs/envelope.md).

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Cube of a level; edges are halved from each level to the next.
struct Cube {
  int level = 0;
  std::array<int, 3> at{};  ///< indices from the first cube, in edges of its level
};

/// Cubes in a box. Cubes that touch each other, even at a corner, differ by at most one level.
class CubeTree {
 public:
  /// Makes unsplit cubes. `low`: first corner; `size`: numbers of cubes of level 0 with edges of `edge`;
  /// `depth`: the last level.
  CubeTree(const Vector3& low, const std::array<int, 3>& size, double edge, int depth)
      : low_(low), size_(size), edge_(edge), depth_(depth) {}

  int depth() const { return depth_; }
  const std::array<int, 3>& size() const { return size_; }
  /// Edge of a cube of this level, in steps of the last level.
  int steps(int level) const { return 1 << (depth_ - level); }
  double edge(int level) const { return edge_ / (1 << level); }
  /// Position of a node, which is counted in steps of the last level.
  Vector3 point(const std::array<int, 3>& node) const {
    return low_ + edge(depth_) * Vector3(node[0], node[1], node[2]);
  }
  bool is_split(const Cube& cube) const { return split_.contains(key(cube)); }
  bool any_split() const { return !split_.empty(); }
  /// Splits a cube, and others that have to be split for it; does nothing at the last level. O(log).
  void split(const Cube& cube);
  /// Unsplit cube that contains the cube of the last level at these steps.
  Cube leaf(const std::array<int, 3>& steps) const;
  /// Unsplit cube that contains a point of the box.
  Cube leaf_at(const Vector3& point) const;

 private:
  static std::uint64_t key(const Cube& cube) {
    std::uint64_t out = std::uint64_t(cube.level);
    for (const int x : cube.at) out = out << 20 | std::uint64_t(x);
    return out;
  }
  bool holds(const Cube& cube) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (cube.at[a] < 0 || cube.at[a] >= size_[a] << cube.level) return false;
    return true;
  }

  Vector3 low_;
  std::array<int, 3> size_;
  double edge_;
  int depth_;
  std::unordered_set<std::uint64_t> split_;
};

}  // namespace hariko

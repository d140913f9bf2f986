#pragma once

// CubeTree: balanced octree of cubes, split where details are small (docs/envelope.md).

#include <cstdint>
#include <limits>
#include <unordered_set>

#include "core/envelope/ball/spline_field.hpp"

namespace hariko {

/// Cube of a level; edges are halved from each level to the next.
struct Cube {
  int level = 0;
  std::array<int, 3> at{};  ///< indices from the first cube, in edges of its level

  /// One of its eight parts.
  Cube part(int c) const {
    return {level + 1, {2 * at[0] + (c & 1), 2 * at[1] + (c >> 1 & 1), 2 * at[2] + (c >> 2)}};
  }
  friend auto operator<=>(const Cube&, const Cube&) = default;
};

/// One number for three indices below 2^20 and a smaller one, for tables.
inline std::uint64_t packed_key(int first, const std::array<int, 3>& at) {
  std::uint64_t out = std::uint64_t(first);
  for (const int x : at) out = out << 20 | std::uint64_t(x);
  return out;
}

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
  /// Lowest corner of a cube, as a node.
  std::array<int, 3> low_node(const Cube& cube) const {
    const int s = steps(cube.level);
    return {cube.at[0] * s, cube.at[1] * s, cube.at[2] * s};
  }
  /// Position of a node, which is counted in steps of the last level.
  Vector3 point(const std::array<int, 3>& node) const {
    return low_ + edge(depth_) * Vector3(node[0], node[1], node[2]);
  }
  bool is_split(const Cube& cube) const { return split_.contains(packed_key(cube.level, cube.at)); }
  bool any_split() const { return !split_.empty(); }
  /// Splits a cube, and others that have to be split for it; does nothing at the last level. O(log).
  void split(const Cube& cube);
  /// Unsplit cube that contains the cube of the last level at these steps.
  Cube leaf(const std::array<int, 3>& steps) const;
  /// Unsplit cube that contains a point of the box.
  Cube leaf_at(const Vector3& point) const;

  /// Begins to keep values of a field at half edges of the cubes of level 0. The depth is at least 1.
  void keep_values() { values_.assign(node_count(halves()), std::numeric_limits<double>::quiet_NaN()); }
  /// Kept value at a place, which is counted in half edges of level 0; not a number until it is found.
  double& kept_value(const std::array<int, 3>& place) {
    return values_[node_index(halves(), place[0], place[1], place[2])];
  }
  /// Kept value at a node in the box; not a number where none is known.
  double known_value(const std::array<int, 3>& node) const {
    const int shift = depth_ - 1;
    if (values_.empty() || ((node[0] | node[1] | node[2]) & ((1 << shift) - 1)) != 0)
      return std::numeric_limits<double>::quiet_NaN();
    return values_[node_index(halves(), node[0] >> shift, node[1] >> shift, node[2] >> shift)];
  }

 private:
  /// Numbers of places at half edges of level 0 along the axes.
  std::array<int, 3> halves() const { return {2 * size_[0] + 1, 2 * size_[1] + 1, 2 * size_[2] + 1}; }
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
  std::vector<double> values_;  ///< see `kept_value`; empty: none are kept
};

/// Cubes that cover the surface, with corners at multiples of `edge` from the object's origin, split where
/// normals in a cube spread too widely for the mesh to represent the surface. `ahead`: cubes of the first
/// level are also split where they would be if they were half as large, as their points lie too far apart to
/// see the smallest parts. Positions are relative to `origin`. The result keeps the field's values that were
/// looked at, for the field's contour. O(cubes of the box).
CubeTree surface_cubes(const SplineField& field, const Vector3& origin, double edge, bool ahead = false);

}  // namespace hariko

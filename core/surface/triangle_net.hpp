#pragma once

// TriangleNet: control nets of triangular Bezier patches, their subdivision and points on them.

#include <array>
#include <span>
#include <vector>

#include "core/surface/patch.hpp"

namespace hariko {

/// Degree n of the triangular Bezier patches that represent a patch exactly, with the control points of
/// `PatchSet::hull`; 0 where the patch has no polynomial control points of its own, or a degree without a
/// hull.
int polynomial_degree(const PatchSet& patches, Index patch);

/// Tables shared by all nets of a degree. Points are in the order of GridPattern{triangle, degree}; side k
/// runs from corner k to the next one. Immutable.
class TriangleNet {
 public:
  static constexpr int max_degree = 12;
  static constexpr std::size_t max_count = 91;
  /// Number of points that `samples` evaluates: those of a grid of 4 intervals without its corners; the
  /// points on side k have the numbers 3 k, 3 k + 1, 3 k + 2.
  static constexpr std::size_t sample_count = 12;

  /// Makes the tables; 1 <= degree <= max_degree.
  explicit TriangleNet(int degree);

  int degree() const { return degree_; }
  std::size_t count() const { return count_; }
  /// Index of a corner's point.
  std::size_t corner(int k) const { return std::size_t(side(k).front()); }
  /// Indices of the points of a side, in its direction.
  std::span<const int> side(int k) const { return {rows_[std::size_t(k)].data(), std::size_t(degree_) + 1}; }

  /// Splits a net at fraction t of a side, by de Casteljau's steps: in `first` the side's end becomes the new
  /// point, in `second` its begin; both keep the order of their corners. `first` may be `net`. O(n^3).
  void split(int side, double t, const Vector3* net, Vector3* first, Vector3* second) const;
  /// Evaluates the `sample_count` points of a net. O(n^2).
  void samples(const Vector3* net, std::span<Vector3, sample_count> out) const;

 private:
  int degree_;
  std::size_t count_;
  /// Rows of points parallel to each side, the side itself first.
  std::array<std::vector<int>, 3> rows_;
  std::vector<double> weights_;  ///< weight of each point in each of the samples
};

/// Shared tables of a degree, made at their first use. Thread-safe.
const TriangleNet& triangle_net(int degree);

}  // namespace hariko

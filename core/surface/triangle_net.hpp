#pragma once

// Control points of triangular Bezier patches: cutting one in two, and points on it.

#include <array>
#include <span>
#include <vector>

#include "core/surface/patch.hpp"

namespace hariko {

/// Degree n of the triangles over which a patch is a polynomial with the control points that
/// `FacetEvaluation::hull` gives; 0 where it is none, or of a degree that has no hull.
int polynomial_degree(const PatchSet& patches, Index patch);

/// What all nets of a degree have in common. Points are in the order of GridPattern{triangle, degree}; side k
/// runs from corner k to the next one. Immutable.
class TriangleNet {
 public:
  static constexpr int max_degree = 12;
  static constexpr std::size_t max_count = 91;
  /// Points at which `samples` evaluates: those of a grid of 4 intervals without its corners, the ones on
  /// side k being 3 k, 3 k + 1, 3 k + 2.
  static constexpr std::size_t sample_count = 12;

  /// 1 <= degree <= max_degree.
  explicit TriangleNet(int degree);

  int degree() const { return degree_; }
  std::size_t count() const { return count_; }
  /// Number of a corner.
  std::size_t corner(int k) const { return std::size_t(side(k).front()); }
  /// Numbers of the points of a side, in its direction.
  std::span<const int> side(int k) const { return {rows_[std::size_t(k)].data(), std::size_t(degree_) + 1}; }

  /// Cuts at fraction t of a side, by de Casteljau's steps: in `first` the side's end becomes the new point,
  /// in `second` its begin; both keep the order of their corners. `first` may be `net`. O(n^3).
  void split(int side, double t, const Vector3* net, Vector3* first, Vector3* second) const;
  void samples(const Vector3* net, std::span<Vector3, sample_count> out) const;

 private:
  int degree_;
  std::size_t count_;
  /// Of each side the rows of points parallel to it, the side itself first.
  std::array<std::vector<int>, 3> rows_;
  std::vector<double> weights_;  ///< of each point at each of the samples
};

/// The one of a degree, made when it is first asked for. Thread-safe.
const TriangleNet& triangle_net(int degree);

}  // namespace hariko

#pragma once

// Control points of a triangular Bezier patch from points on it.

#include <span>
#include <vector>

#include "core/surface/facet_evaluation.hpp"

namespace hariko {

/// Degree n: the control points c of the polynomial whose values at the uniform grid are s are c = M^-1 s,
/// with M the Bernstein polynomials at the grid's points. Immutable; O(n^6) to make.
class TriangleCollocation {
 public:
  /// Above it the inverse loses too many digits.
  static constexpr int max_degree = 12;

  /// 1 <= degree <= max_degree.
  explicit TriangleCollocation(int degree);

  int degree() const { return degree_; }
  int count() const { return count_; }
  /// Row i of M^-1, count() numbers.
  const double* row(int i) const { return inverse_.data() + i * count_; }
  /// How many times the largest error of a value may come back in control point i.
  double amplification(int i) const { return amplification_[std::size_t(i)]; }

  /// The control points with radii that cover rounding. Sizes are count().
  void controls(std::span<const Vector3> samples, std::span<HullBall> out) const;

 private:
  int degree_, count_;
  std::vector<double> inverse_, amplification_;
};

/// The one of a degree, made when it is first asked for. Thread-safe.
const TriangleCollocation& triangle_collocation(int degree);

}  // namespace hariko

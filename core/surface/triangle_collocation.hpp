#pragma once

// TriangleCollocation: control points of a triangular Bezier patch by interpolation of points on it.

#include <span>
#include <vector>

#include "core/surface/patch.hpp"

namespace hariko {

/// Interpolation of degree n: the polynomial with values s at the uniform grid has the control points c =
/// M^-1 s, with M the Bernstein polynomials at the grid's points. Immutable; O(n^6) to make.
class TriangleCollocation {
 public:
  /// Limit of the degree, above which the inverse loses too many digits.
  static constexpr int max_degree = 12;

  /// Inverts the collocation matrix; 1 <= degree <= max_degree.
  explicit TriangleCollocation(int degree);

  int degree() const { return degree_; }
  int count() const { return count_; }
  /// Row i of M^-1, count() numbers.
  const double* row(int i) const { return inverse_.data() + i * count_; }
  /// Error amplification: the largest error of control point i for sample errors of at most 1.
  double amplification(int i) const { return amplification_[std::size_t(i)]; }

  /// Control points, with radii that cover rounding errors. Both spans have size count().
  void controls(std::span<const Vector3> samples, std::span<HullBall> out) const;

 private:
  int degree_, count_;
  std::vector<double> inverse_, amplification_;
};

/// Shared collocation of a degree, made at its first use. Thread-safe.
const TriangleCollocation& triangle_collocation(int degree);

}  // namespace hariko

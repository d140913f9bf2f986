#pragma once

// Placement: where an object of a file stands. Internal to core/exchange.

#include <Eigen/LU>

#include "core/base/vector.hpp"

namespace hariko {

/// x becomes linear x + shift.
struct Placement {
  Matrix3 linear = Matrix3::Identity();
  Vector3 shift = Vector3::Zero();

  Vector3 operator()(const Vector3& point) const { return linear * point + shift; }
  /// First `inner`, then this.
  Placement after(const Placement& inner) const { return {linear * inner.linear, (*this)(inner.shift)}; }
  bool is_same() const { return linear == Matrix3::Identity() && shift == Vector3::Zero(); }
  bool is_finite() const { return linear.allFinite() && shift.allFinite(); }
  bool mirrors() const { return (linear / largest()).determinant() < 0; }
  /// A length becomes less than 1e-12 of another one.
  bool flattens() const;

 private:
  double largest() const { return linear.cwiseAbs().maxCoeff(); }
};

}  // namespace hariko

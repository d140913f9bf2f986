#pragma once

// AffineMap: place of an object in a file. Internal to core/exchange.

#include <Eigen/LU>

#include "core/base/vector.hpp"

namespace hariko {

/// Affine map: x becomes linear x + shift.
struct AffineMap {
  Matrix3 linear = Matrix3::Identity();
  Vector3 shift = Vector3::Zero();

  Vector3 operator()(const Vector3& point) const { return linear * point + shift; }
  /// Composition: first `inner`, then this.
  AffineMap after(const AffineMap& inner) const { return {linear * inner.linear, (*this)(inner.shift)}; }
  /// Whether the map is the identity.
  bool is_same() const { return linear == Matrix3::Identity() && shift == Vector3::Zero(); }
  bool is_finite() const { return linear.allFinite() && shift.allFinite(); }
  /// Whether the map reverses orientation.
  bool mirrors() const { return (linear / largest()).determinant() < 0; }
  /// Whether the map is singular: it shortens one length to less than 1e-12 of another.
  bool flattens() const;

 private:
  double largest() const { return linear.cwiseAbs().maxCoeff(); }
};

}  // namespace hariko

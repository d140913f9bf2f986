#pragma once

// Angles between directions, in radians; accurate near zero and near a half turn.

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/vector.hpp"

namespace hariko {

/// Angle between two vectors of any lengths, 0 .. pi. Zero where one of them is zero.
inline double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Signed angle that turns `a` to `b`, counter-clockwise about a unit `axis` at right angles to both, -pi ..
/// pi.
inline double signed_angle(const Vector3& a, const Vector3& b, const Vector3& axis) {
  return std::atan2(axis.dot(a.cross(b)), a.dot(b));
}

}  // namespace hariko

#pragma once

// Rotations as three Euler angles, for display and input.

#include <Eigen/Geometry>

#include "core/base/vector.hpp"

namespace hariko {

/// Euler angles in degrees about the fixed axes x, then y, then z; x and z within -180 .. 180, y within -90
/// .. 90. Where y is 90 or -90, x and z rotate about the same axis: x is then zero.
Vector3 angles_of(const Eigen::Quaterniond& rotation);
/// Rotation with these Euler angles in degrees, the inverse of `angles_of`.
Eigen::Quaterniond rotation_of(const Vector3& degrees);

}  // namespace hariko

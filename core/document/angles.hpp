#pragma once

// Rotations as three angles, for reading and typing.

#include <Eigen/Geometry>

#include "core/base/vector.hpp"

namespace hariko {

/// Degrees about the fixed axes x, then y, then z; x and z within -180 .. 180, y within -90 .. 90. Where y is
/// 90 or -90, x and z turn about the same axis: x is zero then.
Vector3 angles_of(const Eigen::Quaterniond& rotation);
Eigen::Quaterniond rotation_of(const Vector3& degrees);

}  // namespace hariko

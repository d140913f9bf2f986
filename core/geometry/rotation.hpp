#pragma once

// Rotations from directions.

#include <Eigen/Geometry>

#include "core/base/vector.hpp"

namespace hariko {

/// Rotation by the least angle that takes the direction of `from` to that of `to`; for opposite directions a
/// half turn about some axis across them, and the identity where one of them is zero. Lengths do not matter.
/// Eigen's own version is a singular value decomposition, which takes longer to compile than most whole
/// files.
Eigen::Quaterniond least_rotation(const Vector3& from, const Vector3& to);

}  // namespace hariko

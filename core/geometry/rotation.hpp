#pragma once

// Rotations from directions.

#include <Eigen/Geometry>

#include "core/base/vector.hpp"

namespace hariko {

/// The rotation by the least angle that takes the direction of `from` to that of `to`; between opposite ones
/// a half turn about some axis across, and none where one of them is zero. Lengths do not matter. Eigen's own
/// is a singular value decomposition, which takes compilers longer than most whole files.
Eigen::Quaterniond least_rotation(const Vector3& from, const Vector3& to);

}  // namespace hariko

#pragma once

// Rotations from directions.

#include <Eigen/Geometry>

#include "core/base/vector.hpp"

namespace hariko {

/// The rotation by the least angle that takes the direction of `from` to that of `to`; between opposite ones
/// a half turn about some axis across, and none where one of them is zero. Lengths do not matter. Eigen's own
/// is a singular value decomposition, which takes compilers longer than most whole files.
Eigen::Quaterniond least_rotation(const Vector3& from, const Vector3& to);

/// A rotation that takes the z axis to `direction`, which is not zero: about the axis across both, and for
/// opposite ones a half turn. Right to rounding, but for nearly opposite directions to 1e-3 only. The same
/// bits as Eigen's `FromTwoVectors`, without its singular value decomposition.
Matrix3 turn_of_z(const Vector3& direction);

}  // namespace hariko

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

/// Rotation-minimising step along a curve: the unit vector `across` the unit tangent `from`, carried by
/// double reflection (Wang, Juettler, Zheng and Liu 2008) to the end of `chord`, where the unit tangent is
/// `to`. Of fourth order in the length of the step. Without a chord, at a corner, by the least rotation. The
/// result is a unit vector at right angles to `to`.
Vector3 carried_along(const Vector3& across, const Vector3& from, const Vector3& to, const Vector3& chord);

}  // namespace hariko

#pragma once

// The plane of a section, with axes in it.

#include "core/skinning/skin.hpp"

namespace hariko {

/// Orthonormal columns: to the right, up, and towards one who looks along `direction` (a unit vector). Up is
/// as near to z as it can be; looking along z it is y.
Matrix3 upright_axes(const Vector3& direction);

/// The axes turned as little as possible so that the third one is the opposite of another direction.
Matrix3 carried_axes(const Matrix3& axes, const Vector3& direction);

/// The unit normal of the plane in which the points lie, as nearly as they do; zero where they are on a line.
Vector3 section_normal(const SkinSection& section);

/// The direction in which a section is looked at: its normal, along the path; on a line, the path's own.
Vector3 section_direction_of_view(const Skin& skin, const SkinSection& section);

}  // namespace hariko

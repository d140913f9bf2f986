#pragma once

// Work plane of a section, and axes in it.

#include "core/skinning/skin.hpp"

namespace hariko {

/// Orthonormal axes for a view along `direction` (a unit vector), as columns: right, up, and towards the
/// viewer. Up is as close to z as possible; in views along z it is y.
Matrix3 upright_axes(const Vector3& direction);

/// Axes rotated as little as possible so that the third one is opposite to another direction.
Matrix3 carried_axes(const Matrix3& axes, const Vector3& direction);

/// Unit normal of the plane of the points, from the two points that span it best with their mean; zero where
/// they are collinear. O(points^2).
Vector3 section_normal(const SkinSection& section);

/// Viewing direction for a section: its normal, oriented along the path; if it is a point or a line, the
/// path's direction, for a line perpendicular to it.
Vector3 section_direction_of_view(const Skin& skin, const SkinSection& section);

}  // namespace hariko

#pragma once

// Points, directions and indices: the common types. Lengths are in the document's unit.

#include <Eigen/Core>
#include <cstdint>

namespace hariko {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Dense index of an element in an array; valid only for the value it was taken from (stable names are ids).
using Index = std::uint32_t;
inline constexpr Index no_index = 0xffffffffU;

/// Cross product in the plane: |a| |b| times the sine of the counter-clockwise angle from `a` to `b`.
inline double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace hariko

#pragma once

// Vocabulary types for points, directions and indices. Lengths are in the document's unit.

#include <Eigen/Core>
#include <cstdint>

namespace hariko {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Dense position of an element in an array; valid only for the value it was taken from (stable names are
/// ids).
using Index = std::uint32_t;
inline constexpr Index no_index = 0xffffffffU;

/// What turns `a` to `b`, counted counter-clockwise: |a| |b| sin of the angle.
inline double cross(const Vector2& a, const Vector2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace hariko

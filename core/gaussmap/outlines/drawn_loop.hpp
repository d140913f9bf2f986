#pragma once

// Outline loops drawn on a plane by a few corners.

#include <span>

#include "core/gaussmap/outlines/outline.hpp"

namespace hariko {

struct DrawnLoop {
  Vector3 axis = Vector3::UnitZ();  ///< unit normal of the plane, towards the outer side of the surface
  /// Angle of the normals from the axis, away from the centre of the loop; radians, within (-pi/2, pi/2).
  double tilt = 0.7853981633974483;
  std::size_t count = 32;  ///< number of points of the loop, at least 4
  bool hole = false;       ///< the surface lies outside the loop
};

/// Makes a smooth loop through the corners, drawn in either direction, with points uniform in the turning of
/// its normals, or in arc length where these do not turn. The first corner is its first point. Errors:
/// E_TOO_FEW (fewer than three corners), E_DUP_POINT (neighbours coincide; the element is the corner), E_NAN.
Result<OutlineLoop> drawn_loop(std::span<const Vector3> corners, const DrawnLoop& settings);

}  // namespace hariko

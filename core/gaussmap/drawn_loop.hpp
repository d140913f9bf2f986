#pragma once

// Loops drawn on a plane by a few corners.

#include <span>

#include "core/gaussmap/outline.hpp"

namespace hariko {

struct DrawnLoop {
  Vector3 axis = Vector3::UnitZ();  ///< unit, out of the plane on the outer side of the surface
  /// Turn of the normals from the axis, away from the middle of the loop; radians, within (-pi/2, pi/2).
  double tilt = 0.7853981633974483;
  std::size_t count = 32;  ///< points of the loop, at least 4
  bool hole = false;       ///< the surface lies outside of the loop
};

/// A smooth loop through the corners, whichever way round they were drawn, uniform in the turning of its
/// normals, or in its length where they do not turn. The first corner is its first point. Errors: E_TOO_FEW
/// (fewer than three corners), E_DUP_POINT (neighbours in one place; the element is the corner), E_NAN.
Result<OutlineLoop> drawn_loop(std::span<const Vector3> corners, const DrawnLoop& settings);

}  // namespace hariko

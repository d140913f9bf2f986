#pragma once

// Signed distance to axis-aligned ellipsoids and ellipses.

#include "core/base/vector.hpp"

namespace hariko {

/// Nearest point of an ellipsoid.
struct EllipsoidPlace {
  double distance;  ///< negative inside
  Vector3 normal;   ///< unit, outward, at the nearest point
  Vector3 nearest;
};

/// Nearest point and distance, exact to rounding. `half`: positive half axes.
EllipsoidPlace ellipsoid_place(const Vector3& half, const Vector3& point);

/// Nearest point of an ellipse.
struct EllipsePlace {
  double distance;
  Vector2 normal, nearest;
};
EllipsePlace ellipse_place(const Vector2& half, const Vector2& point);

}  // namespace hariko

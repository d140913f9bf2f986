#pragma once

// Signed distance to ellipsoids and ellipses with axes along the coordinates.

#include "core/base/vector.hpp"

namespace hariko {

struct EllipsoidPlace {
  double distance;  ///< negative inside
  Vector3 normal;   ///< unit, outwards, at the nearest point
  Vector3 nearest;
};

/// Exact to rounding. `half`: positive half axes.
EllipsoidPlace ellipsoid_place(const Vector3& half, const Vector3& point);

struct EllipsePlace {
  double distance;
  Vector2 normal, nearest;
};
EllipsePlace ellipse_place(const Vector2& half, const Vector2& point);

}  // namespace hariko

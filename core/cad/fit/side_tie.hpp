#pragma once

// Ties of a face along its sides: quantities, linear in the control points, that the two faces of an edge are
// to have in common.

#include <array>
#include <vector>

#include "core/cad/fit/spline.hpp"

namespace hariko {

/// Whether the normal is well determined: not where the derivatives are parallel, or nearly, and rounding
/// decides.
bool has_normal(const PatchPoint& point);

/// Change of (s, t) that moves a point along a vector of its tangent plane.
Vector2 move_in(const PatchPoint& point, const Vector3& direction);

/// Normal curvature in one direction of the tangent plane, and the largest absolute one of all directions.
struct NormalBend {
  double across = 0, largest = 0;
};
NormalBend normal_bend(const PatchPoint& point, const Vector3& direction);

/// Factor of a control point in a linear combination.
struct PointShare {
  std::size_t i = 0, j = 0;
  double factor = 0;
};

/// Component, along a unit normal, of a linear combination of control points.
struct SideTie {
  Vector3 normal = Vector3::Zero();
  std::vector<PointShare> shares;

  /// Value of the linear combination.
  Vector3 sum(const SplineSurface& surface) const;
  /// Component of the linear combination along `normal`.
  double of(const SplineSurface& surface) const { return sum(surface).dot(normal); }
};

/// Tie of the derivative across side `side`, divided by `speed`, at parameter `at` (s or t) along the side.
/// Where `normal` is perpendicular to the boundary and `speed` is the derivative's component in the plane and
/// perpendicular to the boundary, its value is the angle (radians, for small angles) by which the face is
/// rotated about the boundary against the plane.
SideTie turn_tie(const SplineSurface& surface, int side, double at, const Vector3& normal, double speed);

/// Tie of the second derivative at parameter `at` along side `side` in the direction in which s or t, growing
/// along the side, changes by `along`, and the parameter across it by `over`. Where that direction is a unit
/// vector perpendicular to the boundary and `normal` is the face's, its value is the normal curvature across
/// the boundary.
SideTie bend_tie(const SplineSurface& surface, int side, double at, const Vector3& normal, double along,
                 double over);

}  // namespace hariko

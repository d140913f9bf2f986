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

}  // namespace hariko

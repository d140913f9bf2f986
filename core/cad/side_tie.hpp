#pragma once

// Ties of a face along its sides: numbers that depend on its control points in a linear way and that the
// faces of an edge are to have in common.

#include <array>
#include <vector>

#include "core/cad/spline.hpp"

namespace hariko {

/// Not where both derivatives are parallel, or nearly: there rounding decides about the normal.
bool has_normal(const PatchPoint& point);

/// Part of a control point in a vector.
struct PointShare {
  std::size_t i = 0, j = 0;
  double factor = 0;
};

/// Component along a unit normal of a sum of control points.
struct SideTie {
  Vector3 normal = Vector3::Zero();
  std::vector<PointShare> shares;

  Vector3 sum(const SplineSurface& surface) const;
  double of(const SplineSurface& surface) const { return sum(surface).dot(normal); }
};

/// The derivative across side `side`, in parts of `speed`, at `at` by s or t: where `normal` is perpendicular
/// to the boundary and `speed` the part of that derivative in the plane and perpendicular to the boundary,
/// the tie is by how much the face is turned against the plane, about the boundary, radians.
SideTie turn_tie(const SplineSurface& surface, int side, double at, const Vector3& normal, double speed);

}  // namespace hariko

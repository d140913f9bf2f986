#pragma once

// Knot shift of closed cubic curves: the nearest representation of the same curve with its knots displaced.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Control points of a closed uniform cubic curve as a function of the position along it. The curve with the
/// control points at(x), at(x + 1), ... has its knots shifted by x and is the nearest such curve (least
/// squares); at(i) is control point i itself. That function is the periodic spline of degree 7 through the
/// control points, because inner products of cubic B-splines are B-splines of degree 7.
class KnotShift {
 public:
  /// Prepares the shift for at least three control points. O(points).
  explicit KnotShift(std::vector<Vector3> points);
  /// Control point at x; periodic; the unit of x is the spacing of control points. O(1).
  Vector3 at(double x) const;

 private:
  std::vector<Vector3> coefficients_;
};

}  // namespace hariko

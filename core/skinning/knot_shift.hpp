#pragma once

// Closed cubic curves with other knots: the same curve, as nearly as can be, with control points elsewhere.

#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Control points of a closed uniform cubic curve as a function of the place along it. The curve with the
/// control points at(x), at(x + 1), ... has its knots shifted by x and is the nearest such curve (least
/// squares); at(i) is control point i itself. That function is the periodic spline of degree 7 through the
/// control points: inner products of cubic B-splines are B-splines of degree 7.
class KnotShift {
 public:
  /// At least three points. O(points).
  explicit KnotShift(std::vector<Vector3> points);
  /// Periodic; one is the distance of two control points. O(1).
  Vector3 at(double x) const;

 private:
  std::vector<Vector3> coefficients_;
};

}  // namespace hariko

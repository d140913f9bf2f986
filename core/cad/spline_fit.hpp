#pragma once

// Splines through given curves and surfaces, with knots halved where they miss them.

#include <functional>

#include "core/cad/spline.hpp"

namespace hariko {

struct FitLimits {
  double distance = 0;          ///< length
  double angle = 0;             ///< radians, between tangents of curves and normals of surfaces
  std::size_t most_spans = 64;  ///< that a span of the beginning may be cut into, each way
};

/// Not where both derivatives are parallel, or nearly: there rounding decides about the normal.
bool has_normal(const PatchPoint& point);

struct FittedCurve {
  SplineCurve curve;
  bool reached = true;
};
/// From the breaks of `start` on. The ends are the function's there, bit for bit.
FittedCurve fit_curve(const SplineSpace& start, const std::function<SplinePoint(double)>& function,
                      const FitLimits& limits);

/// The spline of another space that equals a curve: to rounding where the space has it.
SplineCurve in_space(const SplineCurve& curve, const SplineSpace& space);

struct FittedSurface {
  SplineSurface surface;
  double distance = 0;  ///< largest seen, length
  bool reached = true;
};
/// `boundary(side, space)`: control points along a side, in the direction of growing s or t, for a space that
/// has the breaks of `s` or `t`. `few`: one place a span is looked at.
FittedSurface fit_surface(const SplineSpace& s, const SplineSpace& t,
                          const std::function<PatchPoint(double, double)>& function,
                          const std::function<std::vector<Vector3>(int, const SplineSpace&)>& boundary,
                          const FitLimits& limits, bool few);

}  // namespace hariko

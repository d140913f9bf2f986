#pragma once

// Least-squares fits of curves by splines with few control points.

#include <functional>
#include <limits>
#include <optional>

#include "core/cad/fit/spline.hpp"

namespace hariko {

/// Limits of a fit.
struct FitLimits {
  double distance = 0;  ///< length
  double angle = 0;     ///< radians, between faces along smooth edges
  double turn = 0;      ///< radians, between the normals of faces and those of the surface
  /// Jump of the normal curvature across smooth edges, relative to the largest curvature there; infinite
  /// where the surface's own curvature may jump.
  double bend = std::numeric_limits<double>::infinity();
};

/// Weight of an error along a curve or surface relative to one across it.
inline constexpr double along_share = 0.5;

/// Narrowest span, relative to the whole, that halving may produce: detail finer than that is no smooth
/// shape.
inline constexpr double narrowest_span = 1.0 / 1024;

/// Width of a span in the parameter.
inline double span_width(const SplineSpace& space, std::size_t span) {
  return space.breaks[span + 1] - space.breaks[span];
}
/// Halves the marked spans, except the narrowest; false where none was halved.
bool halve(SplineSpace& space, const std::vector<char>& marked);

/// Gauss-Legendre places and weights over a span, scaled to [0, 1], ascending: exact for polynomials of
/// degree 2 count - 1. 1 <= count <= 16.
struct SpanPlaces {
  std::vector<double> at, weight;
};
/// Gauss-Legendre rule with `count` places, computed once.
const SpanPlaces& span_places(int count);

/// Point of a curve on a surface, with the data that a fit needs there.
struct TracedPoint {
  Vector3 position = Vector3::Zero(), derivative = Vector3::Zero();
  Vector3 normal = Vector3::Zero();  ///< unit normal of the surface; zero where tangents may turn freely
  /// Normal curvature of the surface along the curve, prescribed at the ends of a fitted curve.
  std::optional<double> bend = {};
};

/// Curve with the verdict whether it keeps the limits.
struct FittedCurve {
  SplineCurve curve;
  bool reached = true;
};
/// Curve of a space that equals the given one to `rounding` (a length), if there is one.
std::optional<SplineCurve> equal_curve(const SplineSpace& space,
                                       const std::function<TracedPoint(double)>& function, double rounding);

/// Least-squares fit with prescribed end points, end directions and, where given, end curvatures. Begins with
/// the spans of `start` and halves those where the curve is farther off than `distance` or leaves the tangent
/// plane by more than `turn`. The ends equal the function's, bit for bit.
FittedCurve fit_curve(const SplineSpace& start, const std::function<TracedPoint(double)>& function,
                      const FitLimits& limits);

/// Representation of a curve in another space; equal to rounding where that space contains the curve.
SplineCurve in_space(const SplineCurve& curve, const SplineSpace& space);

}  // namespace hariko

#pragma once

// Splines of few control points near given curves.

#include <functional>
#include <optional>

#include "core/cad/spline.hpp"

namespace hariko {

/// Limits of a fit.
struct FitLimits {
  double distance = 0;  ///< length
  double angle = 0;     ///< radians, between faces along smooth edges
  double turn = 0;      ///< radians, between the normals of faces and those of the surface
};

/// How much a miss along a curve or surface counts beside one across it.
inline constexpr double along_share = 0.5;

/// Spans are cut into halves no narrower than this part of the whole: something there is no smooth shape.
inline constexpr double narrowest_span = 1.0 / 1024;

inline double span_width(const SplineSpace& space, std::size_t span) {
  return space.breaks[span + 1] - space.breaks[span];
}
/// Halves the spans that are marked, but for the narrowest; false where none was.
bool halve(SplineSpace& space, const std::vector<char>& marked);

/// Places and weights for integrals over a span of [0, 1], ascending: exact for polynomials of degree
/// 2 count - 1. 1 <= count <= 16.
struct SpanPlaces {
  std::vector<double> at, weight;
};
const SpanPlaces& span_places(int count);

/// Point of a curve on a surface.
struct TracedPoint {
  Vector3 position = Vector3::Zero(), derivative = Vector3::Zero();
  Vector3 normal = Vector3::Zero();  ///< of the surface, unit; zero where tangents may turn freely
  /// Normal curvature of the surface along the curve, which the end of a fitted curve is to have.
  std::optional<double> bend = {};
};

struct FittedCurve {
  SplineCurve curve;
  bool reached = true;
};
/// A curve of a space that equals the given one, if there is one.
std::optional<SplineCurve> equal_curve(const SplineSpace& space,
                                       const std::function<TracedPoint(double)>& function, double rounding);

/// By least squares, with the end points and the directions in the ends given, and the curvatures where they
/// are, from the spans of `start` on,
/// which are halved where the curve is farther off than the distance or leaves the tangent plane by more than
/// the angle `turn`. The ends are the function's there, bit for bit.
FittedCurve fit_curve(const SplineSpace& start, const std::function<TracedPoint(double)>& function,
                      const FitLimits& limits);

/// The spline of another space that equals a curve: to rounding where the space has it.
SplineCurve in_space(const SplineCurve& curve, const SplineSpace& space);

}  // namespace hariko

#pragma once

// Places on curves: perpendicular feet, points of tangency, nearest points, crossings, and lengths up to
// points.

#include <optional>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Curve given by points on it, in order, of which neighbours differ. Where it turns by less than 30 degrees
/// at a point it is smooth there, at larger turns it has corners. Between the points it is the cubic through
/// them with the tangents of parabolas, so its error is of third order in their distance; straight lines are
/// exact.
struct SampledCurve {
  std::vector<Vector3> points;
  bool closed = false;  ///< the last point is joined with the first
};

/// Point of the curve between two of its points. `span`: number of the first; `share`: 0 there .. 1 at the
/// next. O(1).
Vector3 point_of(const SampledCurve& curve, std::size_t span, double share);
/// Derivative there with respect to the share. O(1).
Vector3 derivative_of(const SampledCurve& curve, std::size_t span, double share);

/// Points where the way from `from` meets the curve at right angles, in the order of the curve. Places at
/// `from` itself are left out, and so are parts that are everywhere at right angles to the way (an arc round
/// `from`). O(points).
std::vector<Vector3> perpendicular_feet(const SampledCurve& curve, const Vector3& from);

/// Points where the line from `from` touches the curve, seen along `normal` (any length but 0), likewise. A
/// straight line is touched nowhere. O(points).
std::vector<Vector3> tangent_places(const SampledCurve& curve, const Vector3& from, const Vector3& normal);

/// Fractions of a to b and of c to d where the lines through these points of the plane cross; nothing where
/// they are parallel (to 1e-9 radians).
std::optional<Vector2> where_lines_cross(const Vector2& a, const Vector2& b, const Vector2& c,
                                         const Vector2& d);
/// The same for the segments between the points, to which their ends belong (with a tolerance of 1e-9 of
/// their lengths): both fractions are within 0 .. 1.
std::optional<Vector2> where_segments_cross(const Vector2& a, const Vector2& b, const Vector2& c,
                                            const Vector2& d);

/// Lengths of a polyline from its first point to each of them; of a closed one its whole length comes last.
/// Zero alone where it has no points. O(points).
std::vector<double> lengths_along(std::span<const Vector3> points, bool closed = false);

/// Fraction of the segment a to b where it is nearest to a point, 0 .. 1; 0 where it has no length.
double nearest_share(const Vector2& a, const Vector2& b, const Vector2& point);

}  // namespace hariko

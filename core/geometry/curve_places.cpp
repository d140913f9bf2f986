#include "core/geometry/curve_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr double least_corner_cosine = 0.8660254037844387;  ///< cosine of 30 degrees
/// Cosines and sines below which a whole span counts as at right angles, or as in line.
constexpr double least_angle = 1e-4;
constexpr double least_way = 1e-9;  ///< from `from`, of a span's distance and length

/// A cubic by its ends and the derivatives there, over 0 .. 1.
struct HermiteSpan {
  Vector3 begin, end, first, last;

  Vector3 at(double s) const {
    const double t = 1 - s;
    return t * t * (1 + 2 * s) * begin + s * s * (3 - 2 * s) * end + s * t * t * first - s * s * t * last;
  }
  Vector3 derivative(double s) const {
    return 6 * s * (1 - s) * (end - begin) + (1 - s) * (1 - 3 * s) * first + s * (3 * s - 2) * last;
  }
};

/// Derivative by the chord length, at b, of the parabola through three points.
Vector3 middle_tangent(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double before = (b - a).norm(), after = (c - b).norm();
  return (after * (b - a) / before + before * (c - b) / after) / (before + after);
}

/// The same at a, where the curve begins.
Vector3 end_tangent(const Vector3& a, const Vector3& b, const Vector3& c) {
  return 2 * (b - a) / (b - a).norm() - middle_tangent(a, b, c);
}

/// Whether a curve is smooth at one of its points; open ends are not.
bool smooth_at(const SampledCurve& curve, std::size_t i) {
  const std::size_t n = curve.points.size();
  if (!curve.closed && (i == 0 || i + 1 == n)) return false;
  const std::vector<Vector3>& p = curve.points;
  const Vector3 before = p[i] - p[(i + n - 1) % n], after = p[(i + 1) % n] - p[i];
  return before.dot(after) > least_corner_cosine * before.norm() * after.norm();
}

HermiteSpan span_of(const SampledCurve& curve, std::size_t i) {
  const std::vector<Vector3>& p = curve.points;
  const std::size_t n = p.size(), j = (i + 1) % n;
  const Vector3 &a = p[i], &b = p[j], &previous = p[(i + n - 1) % n], &next = p[(j + 1) % n];
  const double length = (b - a).norm();
  if (!(length > 0)) return {a, b, Vector3::Zero(), Vector3::Zero()};
  const bool from_smooth = smooth_at(curve, i), to_smooth = smooth_at(curve, j);
  Vector3 first = (b - a) / length, last = first;
  if (from_smooth) first = middle_tangent(previous, a, b);
  if (to_smooth) last = middle_tangent(a, b, next);
  if (from_smooth && !to_smooth) last = -end_tangent(b, a, previous);
  if (to_smooth && !from_smooth) first = end_tangent(a, b, next);
  return {a, b, length * first, length * last};
}

std::size_t span_count(const SampledCurve& curve) {
  const std::size_t n = curve.points.size();
  return n < 2 ? 0 : curve.closed ? n : n - 1;
}

/// Points where a measure of the curve changes its sign. `measure`: of a point and the derivative there, as
/// the cosine or sine of an angle.
std::vector<Vector3> sign_changes(const SampledCurve& curve, const Vector3& from,
                                  const std::function<double(const Vector3&, const Vector3&)>& measure) {
  std::vector<Vector3> out;
  for (std::size_t i = 0; i < span_count(curve); ++i) {
    const HermiteSpan span = span_of(curve, i);
    const auto value = [&](double s) { return measure(span.at(s), span.derivative(s)); };
    const double first = value(0), last = value(1);
    if ((first < 0) == (last < 0)) continue;
    if (std::max(std::abs(first), std::abs(last)) < least_angle) continue;
    double low = 0, high = 1;
    constexpr int halvings = 60;
    for (int step = 0; step < halvings; ++step) {
      const double middle = (low + high) / 2;
      ((value(middle) < 0) == (first < 0) ? low : high) = middle;
    }
    const Vector3 point = span.at((low + high) / 2);
    const double size = (span.end - span.begin).norm() + (from - span.begin).norm();
    if ((point - from).norm() > least_way * size) out.push_back(point);
  }
  return out;
}

}  // namespace

Vector3 point_of(const SampledCurve& curve, std::size_t span, double share) {
  HARIKO_ASSERT(span < span_count(curve), "a span of the curve");
  return span_of(curve, span).at(share);
}

Vector3 derivative_of(const SampledCurve& curve, std::size_t span, double share) {
  HARIKO_ASSERT(span < span_count(curve), "a span of the curve");
  return span_of(curve, span).derivative(share);
}

std::vector<Vector3> perpendicular_feet(const SampledCurve& curve, const Vector3& from) {
  return sign_changes(curve, from, [&](const Vector3& point, const Vector3& along) {
    const double scale = (point - from).norm() * along.norm();
    return scale > 0 ? (point - from).dot(along) / scale : 0.0;
  });
}

std::vector<Vector3> tangent_places(const SampledCurve& curve, const Vector3& from, const Vector3& normal) {
  return sign_changes(curve, from, [&](const Vector3& point, const Vector3& along) {
    const double scale = (point - from).norm() * along.norm() * normal.norm();
    return scale > 0 ? (point - from).cross(along).dot(normal) / scale : 0.0;
  });
}

std::optional<Vector2> where_lines_cross(const Vector2& a, const Vector2& b, const Vector2& c,
                                         const Vector2& d) {
  constexpr double parallel = 1e-9;
  const Vector2 ab = b - a, cd = d - c, ac = c - a;
  const double area = cross(ab, cd);
  if (!(std::abs(area) > parallel * ab.norm() * cd.norm())) return {};
  return Vector2(cross(ac, cd) / area, cross(ac, ab) / area);
}

std::optional<Vector2> where_segments_cross(const Vector2& a, const Vector2& b, const Vector2& c,
                                            const Vector2& d) {
  constexpr double beyond = 1e-9;
  const auto shares = where_lines_cross(a, b, c, d);
  if (!shares || shares->minCoeff() < -beyond || shares->maxCoeff() > 1 + beyond) return {};
  return Vector2(std::clamp(shares->x(), 0.0, 1.0), std::clamp(shares->y(), 0.0, 1.0));
}

std::vector<double> lengths_along(std::span<const Vector3> points, bool closed) {
  std::vector<double> out{0};
  const std::size_t count = points.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
    out.push_back(out.back() + (points[(i + 1) % count] - points[i]).norm());
  return out;
}

double nearest_share(const Vector2& a, const Vector2& b, const Vector2& point) {
  const double square = (b - a).squaredNorm();
  return square > 0 ? std::clamp((point - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
}

}  // namespace hariko

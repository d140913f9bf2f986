#include "core/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Normal of a polygon whose Newell normal vanishes (a symmetric bow tie): that of the longest diagonal from
/// corner 0 and the corner farthest from it. Zero for polygons within a line.
Vector3 widest_normal(std::span<const Vector3> corners) {
  Vector3 diagonal = Vector3::Zero();
  for (const Vector3& p : corners)
    if ((p - corners[0]).squaredNorm() > diagonal.squaredNorm()) diagonal = p - corners[0];
  Vector3 normal = Vector3::Zero();
  for (const Vector3& p : corners) {
    const Vector3 candidate = diagonal.cross(p - corners[0]);
    if (candidate.squaredNorm() > normal.squaredNorm()) normal = candidate;
  }
  return normal.norm() > 1e-12 * diagonal.squaredNorm() ? normal : Vector3::Zero();
}

/// Whether the open segments ab and cd cross in a single inner point.
bool segments_cross(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return ((c_side > 0 && d_side < 0) || (c_side < 0 && d_side > 0)) &&
         ((a_side > 0 && b_side < 0) || (a_side < 0 && b_side > 0));
}

/// Whether two sides cross. The sides are sorted by their left ends; each is compared with those that begin
/// before it ends.
bool crosses_itself(const std::vector<Vector2>& corners) {
  const std::size_t n = corners.size();
  const auto end_of = [&](std::size_t side) -> const Vector2& { return corners[(side + 1) % n]; };
  const auto left = [&](std::size_t side) { return std::min(corners[side].x(), end_of(side).x()); };
  const auto right = [&](std::size_t side) { return std::max(corners[side].x(), end_of(side).x()); };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  std::size_t budget = 2'000'000;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = order[i];
    for (std::size_t j = i + 1; j < n && left(order[j]) <= right(a); ++j) {
      const std::size_t b = order[j];
      if (segments_cross(corners[a], end_of(a), corners[b], end_of(b))) return true;
      if (--budget == 0) return false;
    }
  }
  return false;
}

/// Least triangle area at a corner (negative at a reflex corner) and the polygon's area, both doubled and
/// signed.
struct Turning {
  double least_triangle, area;
};
Turning turning_of(const std::vector<Vector2>& corners) {
  const std::size_t n = corners.size();
  Turning out{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2 &p = corners[(i + n - 1) % n], &q = corners[i], &r = corners[(i + 1) % n];
    out.least_triangle = std::min(out.least_triangle, cross(q - p, r - q));
    out.area += cross(q, r);
  }
  return out;
}

}  // namespace

Vector3 newell_normal(std::span<const Vector3> corners) {
  return newell_normal(corners.size(), [&](std::size_t i) -> const Vector3& { return corners[i]; });
}

std::vector<Vector2> flattened(std::span<const Vector3> points, const Vector3& origin,
                               const Vector3& normal) {
  const Vector3 x = normal.unitOrthogonal(), y = normal.cross(x);
  std::vector<Vector2> out;
  out.reserve(points.size());
  for (const Vector3& p : points) out.emplace_back(x.dot(p - origin), y.dot(p - origin));
  return out;
}

double twice_area(std::span<const Vector2> corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += cross(corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

Vector3 polygon_centre(std::span<const Vector3> corners) {
  HARIKO_ASSERT(!corners.empty(), "a polygon needs corners");
  const Vector3 first = corners.front(), normal = newell_normal(corners);
  Vector3 mean = Vector3::Zero(), moment = Vector3::Zero();
  double extent = 0;
  for (const Vector3& corner : corners) {
    mean += (corner - first) / double(corners.size());
    extent = std::max(extent, (corner - first).squaredNorm());
  }
  if (!(normal.norm() > 1e-12 * extent)) return first + mean;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector3 a = corners[i] - first, b = corners[i + 1] - first;
    moment += a.cross(b).dot(normal) * (a + b) / 3;
  }
  return first + moment / normal.squaredNorm();
}

bool inside_polygon(std::span<const Vector2> corners, const Vector2& point) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vector2 &a = corners[i], &b = corners[j];
    if ((a.y() > point.y()) != (b.y() > point.y()) &&
        point.x() < a.x() + (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

FaceShape classify_face(std::span<const Vector3> corners) {
  if (corners.size() <= 3) return FaceShape::convex;
  Vector3 normal = newell_normal(corners);
  double extent = 0;
  for (const Vector3& p : corners) extent = std::max(extent, (p - corners[0]).squaredNorm());
  if (normal.norm() <= 1e-12 * extent) normal = widest_normal(corners);
  if (normal.isZero(0)) return FaceShape::convex;

  const std::vector<Vector2> flat = flattened(corners, corners[0], normal.normalized());
  const Turning turning = turning_of(flat);
  // Without a reflex corner a polygon with turning number 1 crosses nowhere; stars turn more than once, so
  // they are searched too.
  if (crosses_itself(flat)) return FaceShape::self_crossing;
  return turning.least_triangle < -1e-4 * turning.area ? FaceShape::concave : FaceShape::convex;
}

}  // namespace hariko

#include "core/skinning/edit/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "core/geometry/polygon.hpp"

namespace hariko {

namespace {

constexpr double spacing = 4;  // pixels between samples

std::vector<Vector2> resampled(const std::vector<Vector2>& pixels) {
  std::vector<Vector2> out;
  if (pixels.empty()) return out;
  out.push_back(pixels.front());
  double left = spacing;  // distance left to the next sample
  for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
    const Vector2 way = pixels[i + 1] - pixels[i];
    const double length = way.norm();
    double at = left;
    for (; at <= length && out.size() < 10'000; at += spacing) out.push_back(pixels[i] + way * (at / length));
    left = at - length;
  }
  if ((out.back() - pixels.back()).norm() > 1e-9) out.push_back(pixels.back());
  return out;
}

double length_of(const std::vector<Vector2>& points) {
  double out = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) out += (points[i + 1] - points[i]).norm();
  return out;
}

/// Largest distance of points first .. last from their chord.
double deviation(const std::vector<Vector2>& points, std::size_t first, std::size_t last) {
  double out = 0;
  for (std::size_t i = first; i <= last; ++i)
    out = std::max(out, foot_on_segment(points[first], points[last], points[i]).distance);
  return out;
}

}  // namespace

SegmentFoot foot_on_segment(const Vector2& a, const Vector2& b, const Vector2& point) {
  const Vector2 way = b - a;
  const double square = way.squaredNorm();
  const double along = square > 0 ? std::clamp((point - a).dot(way) / square, 0.0, 1.0) : 0.0;
  return {along, (a + along * way - point).norm()};
}

SegmentCrossing cross_segments(const Vector2& a0, const Vector2& a1, const Vector2& b0, const Vector2& b1) {
  const Vector2 a = a1 - a0, b = b1 - b0;
  const double denominator = cross(a, b);
  if (denominator == 0) return {};
  const double along_a = cross(b0 - a0, b) / denominator, along_b = cross(b0 - a0, a) / denominator;
  return {along_a >= 0 && along_a <= 1 && along_b >= 0 && along_b <= 1, along_a, along_b};
}

Stroke classify_stroke(const std::vector<Vector2>& pixels) {
  const std::vector<Vector2> points = resampled(pixels);
  if (points.size() < 2) return {};
  const double length = length_of(points), gap = (points.back() - points.front()).norm();
  if (gap < std::max(12.0, 0.08 * length) && std::abs(twice_area(points)) / 2 > 150)
    return {StrokeKind::lasso, points};
  if (gap > 20 && deviation(points, 0, points.size() - 1) < std::max(6.0, 0.06 * gap))
    return {StrokeKind::line, {points.front(), points.back()}};
  // Corner that leaves the straightest legs.
  std::size_t corner = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 2; i + 2 < points.size(); ++i) {
    const double a = (points[i] - points.front()).norm(), b = (points.back() - points[i]).norm();
    if (!(a > 0 && b > 0)) continue;
    const double worst = std::max(deviation(points, 0, i) / a, deviation(points, i, points.size() - 1) / b);
    if (worst < least) least = worst, corner = i;
  }
  if (!(least <= 0.1)) return {};
  const Vector2 a = points.front() - points[corner], b = points.back() - points[corner];
  const double angle = std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b)) * 180 / std::numbers::pi;
  if (angle < 8 || angle > 120) return {};
  return {StrokeKind::wedge, {points.front(), points[corner], points.back()}};
}

}  // namespace hariko

#include "core/subdivision/subdivision_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

struct Span {
  int index = 0;
  double t = 0;
};

Span span_at(const SubdivisionCurve& curve, double u) {
  const int spans = curve.spans();
  double x = u * spans;
  if (curve.closed) x -= spans * std::floor(x / spans);
  const int index = std::clamp(int(std::floor(x)), 0, spans - 1);
  return {index, x - index};
}

/// Four control points of a span, with reflections beyond its fixed ends.
std::array<Vector3, 4> span_points(const SubdivisionCurve& curve, int span) {
  const int n = curve.size();
  const auto at = [&](int i) -> const Vector3& { return curve.points[std::size_t((i % n + n) % n)]; };
  const int next = curve.closed ? (span + 1) % n : span + 1;
  std::array<Vector3, 4> out{Vector3::Zero(), at(span), at(span + 1), Vector3::Zero()};
  out[0] = curve.is_fixed(span) ? Vector3(2 * out[1] - out[2]) : at(span - 1);
  out[3] = curve.is_fixed(next) ? Vector3(2 * out[2] - out[1]) : at(span + 2);
  return out;
}

/// Largest distance of two curves, from 8 points per span of the first to their nearest points on the second.
double deviation(const SubdivisionCurve& a, const SubdivisionCurve& b) {
  double out = 0;
  for (int i = 0; i <= 8 * a.spans(); ++i)
    out = std::max(out, nearest_point(b, evaluate(a, i / (8.0 * a.spans())).position).distance);
  return out;
}

}  // namespace

CurvePoint evaluate(const SubdivisionCurve& curve, double u) {
  HARIKO_ASSERT(!curve.points.empty(), "a curve has points");
  if (curve.size() == 1) return {curve.points[0], Vector3::Zero(), Vector3::Zero()};
  const auto [span, t] = span_at(curve, u);
  const auto [a, b, c, d] = span_points(curve, span);
  const double s = 1 - t, n = curve.spans();
  CurvePoint out;
  out.position = (s * s * s * a + (3 * t * t * t - 6 * t * t + 4) * b +
                  (-3 * t * t * t + 3 * t * t + 3 * t + 1) * c + t * t * t * d) /
                 6;
  out.first = (n / 2) * (-s * s * a + (3 * t * t - 4 * t) * b + (-3 * t * t + 2 * t + 1) * c + t * t * d);
  out.second = (n * n) * (s * a + (3 * t - 2) * b + (1 - 3 * t) * c + t * d);
  return out;
}

std::vector<Vector3> limit_points(const SubdivisionCurve& curve) {
  const int n = curve.size();
  std::vector<Vector3> out = curve.points;
  for (int i = 0; i < n; ++i) {
    if (curve.is_fixed(i)) continue;
    const auto& before = curve.points[std::size_t((i + n - 1) % n)];
    const auto& after = curve.points[std::size_t((i + 1) % n)];
    out[std::size_t(i)] = (before + 4 * curve.points[std::size_t(i)] + after) / 6;
  }
  return out;
}

namespace {

std::vector<char> fixed_points(const SubdivisionCurve& curve) {
  std::vector<char> fixed;
  for (int i = 0; i < curve.size(); ++i) fixed.push_back(curve.is_fixed(i));
  return fixed;
}

}  // namespace

LimitSystem::LimitSystem(const SubdivisionCurve& curve) : LimitSystem(fixed_points(curve), curve.closed) {}

LimitSystem::LimitSystem(std::vector<char> fixed, bool closed) : fixed_(std::move(fixed)), closed_(closed) {
  const std::size_t n = fixed_.size();
  HARIKO_ASSERT(n > 0 && (closed ? n >= 3 : fixed_.front() && fixed_.back()), "a system of a curve");
  std::vector<double> diagonal(n, 4.0 / 6);
  lower_.assign(n, 1.0 / 6);
  upper_.assign(n, 1.0 / 6);
  for (std::size_t i = 0; i < n; ++i)
    if (fixed_[i]) diagonal[i] = 1, lower_[i] = upper_[i] = 0;
  const double alpha = upper_[n - 1], beta = lower_[0];  // entries (n-1, 0) and (0, n-1)
  const double gamma = -diagonal[0];
  if (closed_) {
    diagonal[0] -= gamma;
    diagonal[n - 1] -= alpha * beta / gamma;
  }
  inverse_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double pivot = i == 0 ? diagonal[0] : diagonal[i] - lower_[i] * upper_[i - 1] * inverse_[i - 1];
    inverse_[i] = 1 / pivot;
  }
  if (!closed_) return;
  std::vector<Vector3> z(n, Vector3::Zero());
  z[0].x() = gamma;
  z[n - 1].x() = alpha;
  solve_tridiagonal(z.data(), 1);
  for (const Vector3& v : z) correction_.push_back(v.x());
  corner_ratio_ = beta / gamma;
  scale_ = 1 + correction_[0] + corner_ratio_ * correction_[n - 1];
}

void LimitSystem::solve_tridiagonal(Vector3* data, std::size_t stride) const {
  const std::size_t n = fixed_.size();
  for (std::size_t i = 0; i < n; ++i) {
    Vector3& x = data[i * stride];
    if (i > 0) x -= lower_[i] * data[(i - 1) * stride];
    x *= inverse_[i];
  }
  for (std::size_t i = n - 1; i-- > 0;) data[i * stride] -= upper_[i] * inverse_[i] * data[(i + 1) * stride];
}

void LimitSystem::solve(Vector3* data, std::size_t stride) const {
  solve_tridiagonal(data, stride);
  if (!closed_) return;
  const std::size_t n = fixed_.size();
  const Vector3 factor = (data[0] + corner_ratio_ * data[(n - 1) * stride]) / scale_;
  for (std::size_t i = 0; i < n; ++i) data[i * stride] -= correction_[i] * factor;
}

SubdivisionCurve curve_through(std::vector<Vector3> targets, bool closed, std::vector<char> sharp) {
  SubdivisionCurve curve{std::move(targets), closed, std::move(sharp)};
  LimitSystem(curve).solve(curve.points.data());
  return curve;
}

SubdivisionCurve refined(const SubdivisionCurve& curve) {
  SubdivisionCurve out;
  out.closed = curve.closed;
  const int n = curve.size();
  for (int i = 0; i < n; ++i) {
    const Vector3& p = curve.points[std::size_t(i)];
    const Vector3& next = curve.points[std::size_t((i + 1) % n)];
    out.points.push_back(
        curve.is_fixed(i) ? p : Vector3((curve.points[std::size_t((i + n - 1) % n)] + 6 * p + next) / 8));
    if (curve.closed || i + 1 < n) out.points.push_back((p + next) / 2);
  }
  if (!curve.sharp.empty()) {
    out.sharp.assign(out.points.size(), 0);
    for (std::size_t i = 0; i < curve.sharp.size(); ++i) out.sharp[2 * i] = curve.sharp[i];
  }
  return out;
}

Reshaped with_point_inserted(const SubdivisionCurve& curve, int span) {
  HARIKO_ASSERT(span >= 0 && span < curve.spans(), "no such span");
  std::vector<Vector3> targets = limit_points(curve);
  const Vector3 middle = evaluate(curve, (span + 0.5) / curve.spans()).position;
  targets.insert(targets.begin() + span + 1, middle);
  std::vector<char> sharp = curve.sharp;
  if (!sharp.empty()) sharp.insert(sharp.begin() + span + 1, 0);
  Reshaped out{curve_through(std::move(targets), curve.closed, std::move(sharp)), 0};
  out.deviation = deviation(curve, out.curve);
  return out;
}

Reshaped with_point_deleted(const SubdivisionCurve& curve, int point) {
  HARIKO_ASSERT(point >= 0 && point < curve.size() && curve.size() > (curve.closed ? 3 : 2),
                "a curve must be left");
  std::vector<Vector3> targets = limit_points(curve);
  targets.erase(targets.begin() + point);
  std::vector<char> sharp = curve.sharp;
  if (!sharp.empty()) sharp.erase(sharp.begin() + point);
  Reshaped out{curve_through(std::move(targets), curve.closed, std::move(sharp)), 0};
  out.deviation = deviation(curve, out.curve);
  return out;
}

CurveFoot nearest_point(const SubdivisionCurve& curve, const Vector3& target) {
  constexpr int samples = 8;
  CurveFoot best{0, std::numeric_limits<double>::infinity()};
  if (curve.size() == 1) return {0, (curve.points[0] - target).norm()};
  const int count = samples * curve.spans();
  std::vector<double> distance(std::size_t(count) + 1);
  for (int i = 0; i <= count; ++i)
    distance[std::size_t(i)] = (evaluate(curve, double(i) / count).position - target).norm();
  const auto at = [&](int i) {
    if (curve.closed) i = (i + count) % count;
    return i < 0 || i > count ? std::numeric_limits<double>::infinity() : distance[std::size_t(i)];
  };
  for (int i = 0; i <= count; ++i) {
    if (at(i) > at(i - 1) || at(i) > at(i + 1)) continue;
    // Newton steps within one sample of a local minimum; safeguarded by keeping the best. At a corner the
    // derivatives are those of one side, so that the other side gets a separate start.
    const double low = (i - 1.0) / count, high = (i + 1.0) / count;
    const bool corner = i % samples == 0 && curve.is_sharp((i / samples) % curve.size());
    CurveFoot foot{double(i) / count, at(i)};
    for (const double start : {0.0, -0.5, 0.5}) {
      if (start != 0 && !corner) break;
      double u = (i + start) / count;
      if (!curve.closed) u = std::clamp(u, 0.0, 1.0);
      for (int round = 0; round < 20; ++round) {
        const CurvePoint p = evaluate(curve, u);
        const Vector3 gap = target - p.position;
        if (gap.norm() < foot.distance) foot = {u, gap.norm()};
        const double slope = p.first.squaredNorm() - gap.dot(p.second);
        const double step = gap.dot(p.first) / (slope > 0 ? slope : p.first.squaredNorm());
        if (!std::isfinite(step)) break;
        const double next = std::clamp(u + step, low, high);
        if (std::abs(next - u) < 1e-15) break;
        u = curve.closed ? next : std::clamp(next, 0.0, 1.0);
      }
    }
    if (foot.distance < best.distance) best = foot;
  }
  return best;
}

double length(const SubdivisionCurve& curve) {
  double out = 0;
  const int count = 16 * curve.spans();
  if (count <= 0) return 0;
  Vector3 before = evaluate(curve, 0).position;
  for (int i = 1; i <= count; ++i) {
    const Vector3 next = evaluate(curve, double(i) / count).position;
    out += (next - before).norm();
    before = next;
  }
  return out;
}

}  // namespace hariko

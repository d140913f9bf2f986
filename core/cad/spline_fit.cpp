#include "core/cad/spline_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace hariko {

namespace {

/// Narrower spans are not halved: something there is no smooth surface.
constexpr double narrowest = 1.0 / 4096;

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Halves the spans that are marked, the widest ones first where not all of them may be; false where none
/// was.
bool halve(SplineSpace& space, const std::vector<char>& marked, std::size_t most) {
  const auto width = [&](std::size_t i) { return space.breaks[i + 1] - space.breaks[i]; };
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < marked.size(); ++i)
    if (marked[i] && width(i) > narrowest) chosen.push_back(i);
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](std::size_t i, std::size_t j) { return width(i) > width(j); });
  chosen.resize(std::min(chosen.size(), most - std::min(most, space.span_count())));
  for (const std::size_t i : chosen) space.breaks.push_back(0.5 * (space.breaks[i] + space.breaks[i + 1]));
  std::sort(space.breaks.begin(), space.breaks.end());
  return !chosen.empty();
}

}  // namespace

bool has_normal(const PatchPoint& point) {
  return point.ds.cross(point.dt).norm() > 1e-5 * point.ds.norm() * point.dt.norm();
}

FittedCurve fit_curve(const SplineSpace& start, const std::function<SplinePoint(double)>& function,
                      const FitLimits& limits) {
  SplineSpace space = start;
  const std::size_t most = limits.most_spans + start.span_count();
  for (;;) {
    const SplineInterpolation interpolation(space);
    std::vector<Vector3> points;
    for (const double x : interpolation.places()) points.push_back(function(x).position);
    interpolation.solve(points, 1, 1, 0);
    SplineCurve curve{space, std::move(points)};
    std::vector<char> marked(space.span_count(), 0);
    bool missed = false;
    for (std::size_t i = 0; i < marked.size(); ++i)
      for (const double f : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        const double x = space.breaks[i] + f * (space.breaks[i + 1] - space.breaks[i]);
        const SplinePoint want = function(x), got = evaluate(curve, x);
        const double length = want.derivative.norm() * (space.end() - space.begin());
        if ((want.position - got.position).norm() > limits.distance ||
            (length > limits.distance && angle_between(want.derivative, got.derivative) > limits.angle))
          marked[i] = 1, missed = true;
      }
    if (!missed) return {std::move(curve), true};
    SplineSpace finer = space;
    if (!halve(finer, marked, most)) return {std::move(curve), false};
    space = std::move(finer);
  }
}

SplineCurve in_space(const SplineCurve& curve, const SplineSpace& space) {
  if (curve.space == space) return curve;
  const SplineInterpolation interpolation(space);
  std::vector<Vector3> points;
  for (const double x : interpolation.places()) points.push_back(evaluate(curve, x).position);
  interpolation.solve(points, 1, 1, 0);
  points.front() = curve.points.front();
  points.back() = curve.points.back();
  return {space, std::move(points)};
}

namespace {

double width(const SplineSpace& space, std::size_t span) {
  return space.breaks[span + 1] - space.breaks[span];
}

/// Where second derivatives depend on the direction, as at the corners of rational patches, normals come
/// nearer only as fast as spans become narrower. Narrow ones are given half as much again, so that two faces
/// stay within three times the limit; and there is an end, for what is no smooth surface.
double normal_limit(const SplineSpace& s, std::size_t span_s, const SplineSpace& t, std::size_t span_t,
                    double angle) {
  const double widest = std::max(width(s, span_s), width(t, span_t));
  if (widest <= 1.0 / 512) return std::numeric_limits<double>::infinity();
  return widest <= 1.0 / 64 ? 1.5 * angle : angle;
}

struct Place {
  double at = 0;
  std::size_t span = 0;
};
/// None but the ends is a Greville place of a single span: there every spline is right.
constexpr std::array<double, 4> looks{0, 0.1, 0.46, 0.9};
/// Few spans are looked at more closely: at the corners of rational patches what is missed waves between
/// them.
constexpr std::array<double, 9> close_looks{0, 0.04, 0.12, 0.27, 0.46, 0.54, 0.73, 0.88, 0.96};
constexpr std::size_t few_spans = 4;
std::vector<Place> places(const SplineSpace& space, bool few) {
  std::vector<Place> out;
  const std::span<const double> inside = few ? std::span(looks).subspan(2, 1)
                                         : space.span_count() <= few_spans
                                             ? std::span<const double>(close_looks)
                                             : looks;
  for (std::size_t i = 0; i < space.span_count(); ++i)
    for (const double x : inside)
      out.push_back({space.breaks[i] + x * (space.breaks[i + 1] - space.breaks[i]), i});
  if (!few) out.push_back({space.end(), space.span_count() - 1});
  return out;
}

/// What the given sides are off the function's, as a smooth field over the rectangle (Coons) that does not
/// turn normals along the sides: a spline that ran from its boundary to the function within its first span
/// would turn them the more the narrower that span is.
class BoundaryMiss {
 public:
  /// Places in s and t; `sides` in the direction of growing s or t.
  BoundaryMiss(const std::vector<double>& along, const std::vector<double>& up,
               const std::function<PatchPoint(double, double)>& function,
               const std::array<SplineCurve, 4>& sides) {
    const double s0 = along.front(), s1 = along.back(), t0 = up.front(), t1 = up.back();
    for (const double s : along) {
      blend_s_.push_back(blend((s - s0) / (s1 - s0)));
      low_t_.emplace_back(evaluate(sides[0], s).position - function(s, t0).position);
      high_t_.emplace_back(evaluate(sides[2], s).position - function(s, t1).position);
    }
    for (const double t : up) {
      blend_t_.push_back(blend((t - t0) / (t1 - t0)));
      high_s_.emplace_back(evaluate(sides[1], t).position - function(s1, t).position);
      low_s_.emplace_back(evaluate(sides[3], t).position - function(s0, t).position);
    }
  }
  /// At place i along s and j along t.
  Vector3 at(std::size_t i, std::size_t j) const {
    const double a = blend_s_[i], b = blend_t_[j];
    return (1 - b) * (low_t_[i] - (1 - a) * low_t_.front() - a * low_t_.back()) +
           b * (high_t_[i] - (1 - a) * high_t_.front() - a * high_t_.back()) + (1 - a) * low_s_[j] +
           a * high_s_[j];
  }

 private:
  /// 0 to 1 with slopes of zero.
  static double blend(double x) { return x * x * (3 - 2 * x); }
  std::vector<double> blend_s_, blend_t_;
  std::vector<Vector3> low_t_, high_t_, low_s_, high_s_;
};

/// The spline with the given boundary that has the function's values inside, but for what the boundary
/// misses.
SplineSurface interpolate(const SplineSpace& s, const SplineSpace& t,
                          const std::function<PatchPoint(double, double)>& function,
                          const std::function<std::vector<Vector3>(int, const SplineSpace&)>& boundary) {
  SplineSurface out{s, t, std::vector<Vector3>(s.size() * t.size())};
  const SplineInterpolation along(s), up(t);
  const std::size_t m = s.size(), n = t.size();
  const std::array<SplineCurve, 4> sides{SplineCurve{s, boundary(0, s)}, SplineCurve{t, boundary(1, t)},
                                         SplineCurve{s, boundary(2, s)}, SplineCurve{t, boundary(3, t)}};
  const BoundaryMiss miss(along.places(), up.places(), function, sides);
  for (std::size_t j = 1; j + 1 < n; ++j) {
    out.points[out.index(0, j)] = evaluate(sides[3], up.places()[j]).position;
    out.points[out.index(m - 1, j)] = evaluate(sides[1], up.places()[j]).position;
    for (std::size_t i = 1; i + 1 < m; ++i)
      out.points[out.index(i, j)] = function(along.places()[i], up.places()[j]).position + miss.at(i, j);
  }
  if (n > 2) along.solve({out.points.data() + m, m * (n - 2)}, 1, n - 2, m);
  for (std::size_t i = 0; i < m; ++i) {
    out.points[out.index(i, 0)] = sides[0].points[i];
    out.points[out.index(i, n - 1)] = sides[2].points[i];
  }
  up.solve(out.points, m, m, 1);
  for (std::size_t j = 0; j < n; ++j) {
    out.points[out.index(0, j)] = sides[3].points[j];
    out.points[out.index(m - 1, j)] = sides[1].points[j];
  }
  return out;
}

}  // namespace

FittedSurface fit_surface(const SplineSpace& s, const SplineSpace& t,
                          const std::function<PatchPoint(double, double)>& function,
                          const std::function<std::vector<Vector3>(int, const SplineSpace&)>& boundary,
                          const FitLimits& limits, bool few) {
  FittedSurface out;
  SplineSpace across = s, up = t;
  const std::size_t most_s = limits.most_spans + s.span_count(), most_t = limits.most_spans + t.span_count();
  for (;;) {
    out.surface = interpolate(across, up, function, boundary);
    out.distance = 0;
    const SplineEvaluator spline(out.surface);
    std::vector<char> marked_s(across.span_count(), 0), marked_t(up.span_count(), 0);
    out.reached = true;
    const std::vector<Place> along = places(across, few), upward = places(up, few);
    for (const Place& y : upward)
      for (const Place& x : along) {
        const PatchPoint want = function(x.at, y.at), got = spline.at(x.at, y.at);
        const double distance = (want.position - got.position).norm();
        out.distance = std::max(out.distance, distance);
        if (distance <= limits.distance &&
            (!has_normal(want) || angle_between(unit_normal(want), unit_normal(got)) <=
                                      normal_limit(across, x.span, up, y.span, limits.angle)))
          continue;
        marked_s[x.span] = marked_t[y.span] = 1;
        out.reached = false;
      }
    if (out.reached) return out;
    const bool finer_s = halve(across, marked_s, most_s), finer_t = halve(up, marked_t, most_t);
    if (!finer_s && !finer_t) return out;
  }
}

}  // namespace hariko

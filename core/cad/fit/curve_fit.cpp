#include "core/cad/fit/curve_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/solvers/banded_cholesky.hpp"

namespace hariko {

namespace {

SpanPlaces gauss_places(int count) {
  SpanPlaces out;
  for (int k = 1; k <= count; ++k) {
    double x = std::cos(std::numbers::pi * (k - 0.25) / (count + 0.5)), slope = 1;
    for (int round = 0; round < 20; ++round) {  // Newton iteration for a zero of the Legendre polynomial
      double before = 1, value = x;
      for (int n = 2; n <= count; ++n) {
        const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    out.at.push_back(0.5 * (1 - x));
    out.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return out;
}

/// Unit direction at an end; zero where there is none. Patches may have derivatives at a corner that differ
/// from those along the side where two sides run on straight: the limit from inside then decides.
Vector3 end_direction(const std::function<TracedPoint(double)>& function, double end, double inward) {
  const auto direction = [&](double x) -> Vector3 {
    return (inward > 0 ? 1 : -1) * function(x).derivative.stableNormalized();
  };
  const Vector3 at_end = direction(end), near = direction(end + 1e-3 * inward);
  const Vector3 limit = (2 * near - direction(end + 2e-3 * inward)).stableNormalized();
  return (at_end - limit).norm() < 1e-4 ? at_end : limit;
}

/// Control point that an unknown moves, and the direction of the move.
struct Unknown {
  std::size_t point = 0;
  Vector3 direction;
};

/// Samples of a curve at the Gauss places of a space's spans.
struct CurveSamples {
  std::vector<TracedPoint> points;
  std::vector<double> weight;
  std::vector<SplineBasis> basis;

  CurveSamples(const SplineSpace& space, const std::function<TracedPoint(double)>& function) {
    const SpanPlaces& places = span_places(space.degree + 2);
    std::vector<double> at;
    for (std::size_t span = 0; span < space.span_count(); ++span)
      for (std::size_t g = 0; g < places.at.size(); ++g) {
        at.push_back(space.breaks[span] + places.at[g] * span_width(space, span));
        points.push_back(function(at.back()));
        weight.push_back(places.weight[g] * span_width(space, span));
      }
    basis = spline_bases(space, at);
  }
};

/// Prescribed distances of the third control points from each end to the tangent planes there, where given.
using EndHeights = std::array<std::optional<double>, 2>;

/// Least-squares curve of a space; its ends are prescribed, and the directions there where they are known.
class CurveSolver {
 public:
  CurveSolver(const SplineSpace& space, const std::function<TracedPoint(double)>& function,
              const CurveSamples& samples, const EndHeights& heights)
      : space_(space), samples_(samples) {
    const TracedPoint begin = function(space.begin()), end = function(space.end());
    points_.assign(space.size(), Vector3::Zero());
    points_.front() = begin.position;
    points_.back() = end.position;
    const std::size_t last = space.size() - 1;
    for (std::size_t k = 1; k < last; ++k) {
      const bool near_begin = k == 1, near_end = k + 1 == last;
      const double length = space.end() - space.begin();
      Vector3 tangent = near_begin ? end_direction(function, space.begin(), length)
                        : near_end ? end_direction(function, space.end(), -length)
                                   : Vector3(Vector3::Zero());
      // Projects the direction to the tangent plane that all curves of the vertex share.
      if (const TracedPoint& from = near_begin ? begin : end; (near_begin || near_end) && !tangent.isZero(0))
        tangent = (tangent - tangent.dot(from.normal) * from.normal).stableNormalized();
      if (near_begin || near_end) points_[k] = near_begin ? begin.position : end.position;
      if (!(near_begin && near_end) && !tangent.isZero(0)) {
        unknowns_.push_back({k, tangent});
        continue;
      }
      if ((k == 2 && heights[0]) || (k + 2 == last && heights[1])) {
        const TracedPoint& from = k == 2 ? begin : end;
        points_[k] = from.position + *heights[k == 2 ? 0 : 1] * from.normal;
        const Vector3 one = from.normal.unitOrthogonal();
        unknowns_.push_back({k, one});
        unknowns_.push_back({k, from.normal.cross(one)});
        continue;
      }
      for (int axis = 0; axis < 3; ++axis) unknowns_.push_back({k, Vector3::Unit(axis)});
    }
  }

  SplineCurve run() const {
    SplineCurve out{space_, points_};
    if (unknowns_.empty()) return out;
    BandedCholesky matrix(unknowns_.size(), std::size_t(3 * space_.degree + 2));
    std::vector<double> right(unknowns_.size(), 0);
    for (std::size_t k = 0; k < samples_.points.size(); ++k) add(k, matrix, right);
    if (!matrix.factor()) return out;
    matrix.solve(right);
    for (std::size_t u = 0; u < unknowns_.size(); ++u)
      out.points[unknowns_[u].point] += right[u] * unknowns_[u].direction;
    return out;
  }

 private:
  void add(std::size_t sample, BandedCholesky& matrix, std::vector<double>& right) const {
    const TracedPoint& want = samples_.points[sample];
    const SplineBasis& basis = samples_.basis[sample];
    const std::size_t end = basis.first + std::size_t(space_.degree);
    Vector3 miss = want.position;
    for (std::size_t k = basis.first; k <= end; ++k) miss -= basis.value[k - basis.first] * points_[k];
    const Vector3 tangent = want.derivative.stableNormalized();
    const auto weighted = [&](const Vector3& v) -> Vector3 {
      return samples_.weight[sample] * (v - (1 - along_share * along_share) * v.dot(tangent) * tangent);
    };
    const auto from = std::lower_bound(unknowns_.begin(), unknowns_.end(), basis.first,
                                       [](const Unknown& u, std::size_t k) { return u.point < k; });
    for (auto u = from; u != unknowns_.end() && u->point <= end; ++u) {
      const Vector3 row = basis.value[u->point - basis.first] * weighted(u->direction);
      const auto i = std::size_t(u - unknowns_.begin());
      right[i] += row.dot(miss);
      for (auto v = from; v <= u; ++v)
        matrix.entry(i, std::size_t(v - unknowns_.begin())) +=
            basis.value[v->point - basis.first] * row.dot(v->direction);
    }
  }

  const SplineSpace& space_;
  const CurveSamples& samples_;
  std::vector<Vector3> points_;
  std::vector<Unknown> unknowns_;  ///< by control point, ascending
};

/// Heights that give a curve its prescribed end curvatures: the normal part of the second derivative is the
/// curvature times the squared length of the first.
EndHeights end_heights(const SplineCurve& curve, const std::function<TracedPoint(double)>& function) {
  EndHeights out;
  const SplineSpace& space = curve.space;
  if (space.size() < 6) return out;
  const double degree = space.degree;
  const std::size_t spans = space.span_count();
  for (const bool at_end : {false, true}) {
    const double x = at_end ? space.end() : space.begin();
    const TracedPoint point = function(x);
    if (!point.bend || point.normal.isZero(0)) continue;
    const double first = span_width(space, at_end ? spans - 1 : 0),
                 both = spans > 1 ? first + span_width(space, at_end ? spans - 2 : 1) : first;
    out[at_end ? 1 : 0] =
        *point.bend * evaluate(curve, x).derivative.squaredNorm() * first * both / (degree * (degree - 1));
  }
  return out;
}

/// Least-squares curve in one space. The first fit gives the speeds at the ends, on which the heights depend.
SplineCurve nearest_curve(const SplineSpace& space, const std::function<TracedPoint(double)>& function) {
  const CurveSamples samples(space, function);
  SplineCurve out = CurveSolver(space, function, samples, {}).run();
  for (int round = 0; round < 3; ++round) {
    const EndHeights heights = end_heights(out, function);
    if (!heights[0] && !heights[1]) break;
    out = CurveSolver(space, function, samples, heights).run();
  }
  return out;
}

/// Deviation of a curve from the wanted point at a place, in multiples of the limits.
double miss_at(const SplineCurve& curve, double x, const TracedPoint& want, const FitLimits& limits) {
  const SplinePoint got = evaluate(curve, x);
  const Vector3 tangent = want.derivative.stableNormalized(), miss = want.position - got.position;
  const double along = miss.dot(tangent);
  double out = std::max((miss - along * tangent).norm(), along_share * std::abs(along)) / limits.distance;
  const double length = got.derivative.norm() * (curve.space.end() - curve.space.begin());
  if (length > limits.distance) {
    // A deviation of `distance` over one span turns the curve by this angle.
    const double turn = limits.turn + limits.distance / (got.derivative.norm() *
                                                         span_width(curve.space, curve.space.span(x)));
    out = std::max(out, std::abs(got.derivative.dot(want.normal)) / (got.derivative.norm() * turn));
  }
  return out;
}

}  // namespace

bool halve(SplineSpace& space, const std::vector<char>& marked) {
  const double least = 1.5 * narrowest_span * (space.end() - space.begin());
  std::vector<double> out;
  for (std::size_t i = 0; i < space.span_count(); ++i) {
    out.push_back(space.breaks[i]);
    const double width = span_width(space, i);
    if (marked[i] && width > least) out.push_back(space.breaks[i] + 0.5 * width);
  }
  out.push_back(space.end());
  const bool some = out.size() > space.breaks.size();
  space.breaks = std::move(out);
  return some;
}

const SpanPlaces& span_places(int count) {
  static const std::array<SpanPlaces, 17> all = [] {
    std::array<SpanPlaces, 17> out;
    for (int k = 1; k <= 16; ++k) out[std::size_t(k)] = gauss_places(k);
    return out;
  }();
  return all[std::size_t(count)];
}

std::optional<SplineCurve> equal_curve(const SplineSpace& space,
                                       const std::function<TracedPoint(double)>& function, double rounding) {
  const SplineInterpolation interpolation(space);
  SplineCurve curve{space, {}};
  for (const double x : interpolation.places()) curve.points.push_back(function(x).position);
  interpolation.solve(curve.points, 1, 1, 0);
  for (std::size_t i = 0; i < space.span_count(); ++i)
    for (const double f : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      const double x = space.breaks[i] + f * (space.breaks[i + 1] - space.breaks[i]);
      if ((function(x).position - evaluate(curve, x).position).norm() > rounding) return {};
    }
  return curve;
}

FittedCurve fit_curve(const SplineSpace& start, const std::function<TracedPoint(double)>& function,
                      const FitLimits& limits) {
  SplineSpace space = start;
  for (;;) {
    FittedCurve out{nearest_curve(space, function), true};
    std::vector<double> misses(space.span_count(), 0);
    for (std::size_t i = 0; i < misses.size(); ++i)
      for (const double f : {0.04, 0.13, 0.26, 0.4, 0.5, 0.6, 0.74, 0.87, 0.96}) {
        const double x = space.breaks[i] + f * (space.breaks[i + 1] - space.breaks[i]);
        misses[i] = std::max(misses[i], miss_at(out.curve, x, function(x), limits));
      }
    const double worst = *std::max_element(misses.begin(), misses.end());
    if (!(worst > 1)) return out;
    std::vector<char> marked;
    for (const double miss : misses) marked.push_back(miss > std::max(1.0, 0.25 * worst));
    out.reached = false;
    if (!halve(space, marked)) return out;
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

}  // namespace hariko

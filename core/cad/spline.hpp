#pragma once

// B-splines as CAD files hold them: clamped ends, simple knots between, so that a spline of degree p has p -
// 1 continuous derivatives. Curves and tensor surfaces in space, without weights.

#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

inline constexpr int max_spline_degree = 9;

/// Splines of one degree over the same breaks: ascending, the ends included, at least two.
struct SplineSpace {
  int degree = 3;
  std::vector<double> breaks{0, 1};

  std::size_t span_count() const { return breaks.size() - 1; }
  std::size_t size() const { return span_count() + std::size_t(degree); }  ///< control points
  double begin() const { return breaks.front(); }
  double end() const { return breaks.back(); }
  /// Every knot, the ends degree + 1 times.
  std::vector<double> knots() const;
  /// Means of `degree` successive knots: one place a control point, ends included.
  std::vector<double> greville() const;
  /// The span that x lies in; of two spans at a break the upper one, but for the end.
  std::size_t span(double x) const;
  /// The same space over the breaks in reverse: x becomes begin + end - x.
  SplineSpace reversed() const;
  friend bool operator==(const SplineSpace&, const SplineSpace&) = default;
};

/// The degree + 1 functions that are not zero on a span, with first and second derivatives. The first of them
/// belongs to control point `first`.
struct SplineBasis {
  std::size_t first = 0;
  std::array<double, max_spline_degree + 1> value{}, derivative{}, second{};
};
SplineBasis spline_basis(const SplineSpace& space, const std::vector<double>& knots, double x);
std::vector<SplineBasis> spline_bases(const SplineSpace& space, std::span<const double> places);

struct SplineCurve {
  SplineSpace space;
  std::vector<Vector3> points;
};
struct SplinePoint {
  Vector3 position = Vector3::Zero(), derivative = Vector3::Zero();
};
SplinePoint evaluate(const SplineCurve& curve, double x);
SplineCurve reversed(const SplineCurve& curve);

/// Control point (i, j), i along s, is points[j s.size() + i].
struct SplineSurface {
  SplineSpace s, t;
  std::vector<Vector3> points;

  std::size_t index(std::size_t i, std::size_t j) const { return j * s.size() + i; }
};
/// Many points of one surface.
class SplineEvaluator {
 public:
  explicit SplineEvaluator(const SplineSurface& surface);
  /// Position and derivatives; where `order` is first, second ones are zero.
  PatchPoint at(double s, double t, Order order = Order::first) const;

 private:
  const SplineSurface& surface_;
  std::vector<double> knots_s_, knots_t_;
};

/// Points with first derivatives at every pair of places, those of `s` one after another: (i, j) is
/// out[j s.size() + i]. O(degree) a point.
std::vector<PatchPoint> evaluate_grid(const SplineSurface& surface, std::span<const SplineBasis> s,
                                      std::span<const SplineBasis> t);

/// The spline of a space that has given values at the space's Greville places. Splines of the space are
/// reproduced to rounding.
class SplineInterpolation {
 public:
  explicit SplineInterpolation(const SplineSpace& space);
  ~SplineInterpolation();
  SplineInterpolation(SplineInterpolation&&) noexcept;

  const std::vector<double>& places() const { return places_; }
  /// Control points of `count` splines at once: value i of spline k is values[i stride + k offset], and is
  /// replaced by control point i. The ends are the values there, bit for bit.
  void solve(std::span<Vector3> values, std::size_t stride, std::size_t count, std::size_t offset) const;

 private:
  struct Factors;
  std::vector<double> places_;
  std::unique_ptr<Factors> factors_;
};

}  // namespace hariko

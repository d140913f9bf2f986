#pragma once

// B-splines as in CAD files: clamped ends and simple inner knots, so that a spline of degree p has p - 1
// continuous derivatives. Curves and tensor-product surfaces in space, without weights.

#include <memory>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Largest degree that evaluation supports.
inline constexpr int max_spline_degree = 9;

/// Space of splines of one degree over given breaks: ascending, the ends included, at least two.
struct SplineSpace {
  int degree = 3;
  std::vector<double> breaks{0, 1};

  std::size_t span_count() const { return breaks.size() - 1; }
  std::size_t size() const { return span_count() + std::size_t(degree); }  ///< control points
  double begin() const { return breaks.front(); }
  double end() const { return breaks.back(); }
  /// Knot vector, with the ends degree + 1 times.
  std::vector<double> knots() const;
  /// Greville abscissae: means of `degree` successive knots, one for each control point, ends included.
  std::vector<double> greville() const;
  /// Number of the span that contains x; at a break the upper one, except at the end.
  std::size_t span(double x) const;
  /// Reversed space, in which x becomes begin + end - x.
  SplineSpace reversed() const;
  friend bool operator==(const SplineSpace&, const SplineSpace&) = default;
};

/// Values of the degree + 1 basis functions that are not zero on a span, with first and second derivatives.
/// The first of them belongs to control point `first`.
struct SplineBasis {
  std::size_t first = 0;
  std::array<double, max_spline_degree + 1> value{}, derivative{}, second{};
};
/// Basis functions at x; `knots` are those of the space. O(degree^2 + log spans).
SplineBasis spline_basis(const SplineSpace& space, const std::vector<double>& knots, double x);
/// Basis functions at several places.
std::vector<SplineBasis> spline_bases(const SplineSpace& space, std::span<const double> places);

/// B-spline curve in space.
struct SplineCurve {
  SplineSpace space;
  std::vector<Vector3> points;
};
/// Point of a curve with its first derivative.
struct SplinePoint {
  Vector3 position = Vector3::Zero(), derivative = Vector3::Zero();
};
/// Position and first derivative at x. O(degree^2 + spans).
SplinePoint evaluate(const SplineCurve& curve, double x);
/// The same curve run backwards, over the reversed space.
SplineCurve reversed(const SplineCurve& curve);

/// Tensor-product B-spline surface. Control point (i, j), i along s, is points[j s.size() + i].
struct SplineSurface {
  SplineSpace s, t;
  std::vector<Vector3> points;

  /// Position of control point (i, j) in `points`.
  std::size_t index(std::size_t i, std::size_t j) const { return j * s.size() + i; }
};
/// Evaluates many points of one surface, which must outlive it.
class SplineEvaluator {
 public:
  explicit SplineEvaluator(const SplineSurface& surface);
  /// Position and derivatives; where `order` is first, second ones are zero.
  PatchPoint at(double s, double t, Order order = Order::first) const;

 private:
  const SplineSurface& surface_;
  std::vector<double> knots_s_, knots_t_;
};

/// Points with first derivatives at all pairs of places, those along `s` consecutive: (i, j) is out[j
/// s.size() + i]. O(degree) a point, amortised.
std::vector<PatchPoint> evaluate_grid(const SplineSurface& surface, std::span<const SplineBasis> s,
                                      std::span<const SplineBasis> t);

/// Interpolation in a spline space at its Greville places. Splines of the space are reproduced to rounding.
class SplineInterpolation {
 public:
  explicit SplineInterpolation(const SplineSpace& space);
  ~SplineInterpolation();
  SplineInterpolation(SplineInterpolation&&) noexcept;

  const std::vector<double>& places() const { return places_; }
  /// Control points of `count` splines at once: value i of spline k is values[i stride + k offset], and is
  /// replaced by control point i. The end control points equal the end values, bit for bit.
  void solve(std::span<Vector3> values, std::size_t stride, std::size_t count, std::size_t offset) const;

 private:
  struct Factors;
  std::vector<double> places_;
  std::unique_ptr<Factors> factors_;
};

}  // namespace hariko

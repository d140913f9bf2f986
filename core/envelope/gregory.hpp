#pragma once

// Gregory patches: bicubically blended Coons patches with variable twists, for points with any number of
// coordinates.

#include <array>
#include <functional>
#include <span>

#include "core/base/assert.hpp"
#include "core/surface/patch.hpp"

namespace hariko::gregory {

/// Values of a polynomial basis at a parameter, with two derivatives.
template <std::size_t N>
struct Blend {
  std::array<double, N> value{}, first{}, second{};
};

/// Cubic Hermite basis: factors of value, derivative, derivative, value.
inline Blend<4> hermite_at(double t) {
  Blend<4> out;
  out.value = {1 - 3 * t * t + 2 * t * t * t, t - 2 * t * t + t * t * t, t * t * t - t * t,
               3 * t * t - 2 * t * t * t};
  out.first = {-6 * t + 6 * t * t, 1 - 4 * t + 3 * t * t, 3 * t * t - 2 * t, 6 * t - 6 * t * t};
  out.second = {-6 + 12 * t, -4 + 6 * t, 6 * t - 2, 6 - 12 * t};
  return out;
}

/// Bernstein polynomials, bit-identical from either end; y is 1 - x.
template <std::size_t N>
std::array<double, N> bernstein_values(double x, double y) {
  std::array<double, N> px, py, out;
  px[0] = py[0] = 1;
  for (std::size_t i = 1; i < N; ++i) px[i] = px[i - 1] * x, py[i] = py[i - 1] * y;
  double choose = 1;
  for (std::size_t i = 0; i < N; ++i) {
    out[i] = choose * (px[i] * py[N - 1 - i]);
    choose = choose * double(N - 1 - i) / double(i + 1);
  }
  return out;
}

/// Bernstein polynomials with derivatives; y is 1 - x.
template <std::size_t N>
Blend<N> bernstein_at(double x, double y) {
  Blend<N> out;
  out.value = bernstein_values<N>(x, y);
  const auto lower = bernstein_values<N - 1>(x, y);
  const auto lowest = bernstein_values<N - 2>(x, y);
  const auto at = [](const auto& values, std::size_t i, std::size_t back) {
    return i >= back && i - back < values.size() ? values[i - back] : 0.0;
  };
  for (std::size_t i = 0; i < N; ++i) {
    out.first[i] = double(N - 1) * (at(lower, i, 1) - at(lower, i, 0));
    out.second[i] = double((N - 1) * (N - 2)) * (at(lowest, i, 2) - 2 * at(lowest, i, 1) + at(lowest, i, 0));
  }
  return out;
}

/// Weighted sum of points, bit-identical from either end.
template <class Point, std::size_t N>
Point sum(const std::array<double, N>& weight, const std::array<Point, N>& point) {
  Point out = weight[0] * point[0] + weight[N - 1] * point[N - 1];
  for (std::size_t i = 1; i < N / 2; ++i) out += weight[i] * point[i] + weight[N - 1 - i] * point[N - 1 - i];
  if constexpr (N % 2 == 1) out += weight[N / 2] * point[N / 2];
  return out;
}

/// The four curves of one direction (value, cross, cross, value) at a parameter.
template <class Point>
struct Rails {
  std::array<Point, 4> value, first, second;
};
/// Evaluates the four curves. `side`, `cross`: bases of the degree of the sides and of the fields across
/// them.
template <std::size_t M, std::size_t N, class Side, class Field>
auto rails(const Side& a, const Field& cross_a, const Field& cross_b, const Side& b, const Blend<M>& side,
           const Blend<N>& cross, Order order) {
  using Point = typename Side::value_type;
  const auto all = [&](const auto& s, const auto& c) {
    return std::array<Point, 4>{sum(s, a), sum(c, cross_a), sum(c, cross_b), sum(s, b)};
  };
  Rails<Point> out;
  out.value = all(side.value, cross.value);
  out.first = all(side.first, cross.first);
  if (order == Order::second) out.second = all(side.second, cross.second);
  return out;
}

/// Tensor-product part that both blends count twice; twists are `constant` + x `share` with x = p / (p + q),
/// p and q the distances from the corner along u and v.
template <class Point>
struct Corners {
  std::array<std::array<Point, 4>, 4> constant;
  std::array<std::array<Point, 2>, 2> share;
};
/// Makes the corner terms. `Patch`: Bezier curves c0, c1 along u, e0, e1 along v, and the derivatives across
/// them, cross_c0 ...
template <class Patch>
auto corners_of(const Patch& p) {
  using Point = typename decltype(p.c0)::value_type;
  const auto rate = [](const auto& c, bool end) -> Point {
    const std::size_t n = c.size() - 1;
    return end ? Point(double(n) * (c[n] - c[n - 1])) : Point(double(n) * (c[1] - c[0]));
  };
  Corners<Point> out;
  out.constant[0] = {p.c0.front(), rate(p.e0, false), rate(p.e0, true), p.c1.front()};
  out.constant[3] = {p.c0.back(), rate(p.e1, false), rate(p.e1, true), p.c1.back()};
  for (std::size_t i = 0; i < 2; ++i) {
    out.constant[1 + i][0] = rate(p.c0, i == 1);
    out.constant[1 + i][3] = rate(p.c1, i == 1);
    for (std::size_t j = 0; j < 2; ++j) {
      const Point by_u = rate(i == 0 ? p.cross_e0 : p.cross_e1, j == 1);
      const Point by_v = rate(j == 0 ? p.cross_c0 : p.cross_c1, i == 1);
      out.constant[1 + i][1 + j] = by_v;
      out.share[i][j] = by_u - by_v;
    }
  }
  return out;
}

/// Ratio p / (p + q) with derivatives; 1/2 at the corner, where its factor vanishes.
struct Ratio {
  double value, p, q, pp, pq, qq;
};
/// Ratio of the distances p and q from the corner.
inline Ratio ratio(double p, double q) {
  const double s = p + q;
  if (!(s > 0)) return {0.5, 0, 0, 0, 0, 0};
  const double s2 = s * s, s3 = s2 * s;
  return {p / s, q / s2, -p / s2, -2 * q / s3, (p - q) / s3, 2 * p / s3};
}

/// Point of a patch with derivatives by u and v.
template <class Point>
struct Jet {
  Point value = Point::Zero(), u = Point::Zero(), v = Point::Zero();
  Point uu = Point::Zero(), uv = Point::Zero(), vv = Point::Zero();
};

/// Curves across at a v, less the part that both blends count twice: the same for all points with this v.
template <class Point>
Rails<Point> row_at(const Corners<Point>& m, Rails<Point> across, const Blend<4>& v, Order order) {
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = 0; l < 4; ++l) {
      across.value[k] -= v.value[l] * m.constant[k][l];
      across.first[k] -= v.first[l] * m.constant[k][l];
      if (order == Order::second) across.second[k] -= v.second[l] * m.constant[k][l];
    }
  return across;
}

/// Coons patch H(u) . across(v) + H(v) . along(u) - H(u) M H(v), without the variable part of the twists.
template <class Point>
Jet<Point> coons(const Rails<Point>& row, const Rails<Point>& along, const Blend<4>& u, const Blend<4>& v,
                 Order order) {
  Jet<Point> out;
  for (std::size_t k = 0; k < 4; ++k) {
    out.value += u.value[k] * row.value[k] + v.value[k] * along.value[k];
    out.u += u.first[k] * row.value[k] + v.value[k] * along.first[k];
    out.v += u.value[k] * row.first[k] + v.first[k] * along.value[k];
    if (order != Order::second) continue;
    out.uu += u.second[k] * row.value[k] + v.value[k] * along.second[k];
    out.uv += u.first[k] * row.first[k] + v.first[k] * along.first[k];
    out.vv += u.value[k] * row.second[k] + v.second[k] * along.value[k];
  }
  return out;
}

/// Factors of the corners' shares in the variable part of the twists, with derivatives.
struct TwistFactors {
  struct Factor {
    double value, u, v, uu, uv, vv;
  };
  std::array<std::array<Factor, 2>, 2> at;
};
/// Factors at (s, t), for all patches.
inline TwistFactors twist_factors(double s, const Blend<4>& u, double t, const Blend<4>& v) {
  TwistFactors out;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const double su = i == 0 ? 1 : -1, sv = j == 0 ? 1 : -1;
      const Ratio x = ratio(i == 0 ? s : 1 - s, j == 0 ? t : 1 - t);
      const double xu = su * x.p, xv = sv * x.q;
      const double a = u.value[1 + i], au = u.first[1 + i], auu = u.second[1 + i];
      const double b = v.value[1 + j], bv = v.first[1 + j], bvv = v.second[1 + j];
      out.at[i][j] = {a * b * x.value,
                      b * (au * x.value + a * xu),
                      a * (bv * x.value + b * xv),
                      b * (auu * x.value + 2 * au * xu + a * x.pp),
                      au * bv * x.value + au * b * xv + a * bv * xu + a * b * su * sv * x.pq,
                      a * (bvv * x.value + 2 * bv * xv + b * x.qq)};
    }
  return out;
}

/// Subtracts the variable part of the twists.
template <class Point>
void subtract_twists(const Corners<Point>& m, const TwistFactors& factors, Order order, Jet<Point>& out) {
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const TwistFactors::Factor& factor = factors.at[i][j];
      const Point& share = m.share[i][j];
      out.value -= factor.value * share;
      out.u -= factor.u * share;
      out.v -= factor.v * share;
      if (order != Order::second) continue;
      out.uu -= factor.uu * share;
      out.vv -= factor.vv * share;
      out.uv -= factor.uv * share;
    }
}

/// Set of square patches with Gregory's twists, which evaluates the points of a grid together.
class GridPatchSet : public PatchSet {
 public:
  Domain domain() const override { return Domain::square; }
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern, std::span<Vector3> positions,
                     std::span<Vector3> normals) const override {
    std::size_t at = 0;
    for_grid(patches, pattern, Order::first,
             [&](Index patch, const Vector2& parameter, const PatchPoint& point) {
               positions[at] = point.position;
               normals[at++] = normal_at(patch, parameter, point);
             });
  }
  void evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                     std::span<PatchPoint> points) const override {
    HARIKO_ASSERT(points.size() >= patches.size() * std::size_t(pattern.point_count()),
                  "output array is too small");
    std::size_t at = 0;
    for_grid(patches, pattern, Order::second,
             [&](Index, const Vector2&, const PatchPoint& point) { points[at++] = point; });
  }
  /// Not exact: Gregory's twists depend on the direction at corners.
  CornerSecondOrder second_order_at_corner(Index patch, int corner) const override {
    return unit_normal(evaluate(patch, corner_parameter(Domain::square, corner), Order::first)).isZero(0)
               ? CornerSecondOrder::undefined
               : CornerSecondOrder::direction_dependent;
  }

 protected:
  using EachPoint = std::function<void(Index patch, const Vector2& parameter, const PatchPoint& point)>;

 private:
  /// Calls `each` for every point of the grid on every patch.
  virtual void for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                        const EachPoint& each) const = 0;
};

}  // namespace hariko::gregory

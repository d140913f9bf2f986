#include "core/envelope/ball/hermite_patch.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Polynomials of one kind at a parameter, with two derivatives.
template <std::size_t N>
struct Blend {
  std::array<double, N> value{}, first{}, second{};
};

/// The same bits from either end: y is 1 - x.
Blend<6> quintic_at(double x, double y) {
  const double x2 = x * x, y2 = y * y, x3 = x2 * x, y3 = y2 * y, x4 = x2 * x2, y4 = y2 * y2;
  Blend<6> out;
  out.value = {y4 * y, 5 * (x * y4), 10 * (x2 * y3), 10 * (x3 * y2), 5 * (x4 * y), x4 * x};
  const std::array<double, 5> lower{y4, 4 * (x * y3), 6 * (x2 * y2), 4 * (x3 * y), x4};
  const std::array<double, 4> lowest{y3, 3 * (x * y2), 3 * (x2 * y), x3};
  for (std::size_t i = 0; i < 6; ++i) {
    out.first[i] = 5 * ((i > 0 ? lower[i - 1] : 0) - (i < 5 ? lower[i] : 0));
    const auto low = [&](std::size_t back) { return i >= back && i - back < 4 ? lowest[i - back] : 0.0; };
    out.second[i] = 20 * (low(2) - 2 * low(1) + low(0));
  }
  return out;
}

/// Factors of value, derivative, derivative, value.
Blend<4> hermite_at(double t) {
  Blend<4> out;
  out.value = {1 - 3 * t * t + 2 * t * t * t, t - 2 * t * t + t * t * t, t * t * t - t * t,
               3 * t * t - 2 * t * t * t};
  out.first = {-6 * t + 6 * t * t, 1 - 4 * t + 3 * t * t, 3 * t * t - 2 * t, 6 * t - 6 * t * t};
  out.second = {-6 + 12 * t, -4 + 6 * t, 6 * t - 2, 6 - 12 * t};
  return out;
}

/// 64 t^3 (1 - t)^3 (1, t, t^2), along a side.
Blend<3> bump_at(double t) {
  const double s = 1 - t;
  const double f = 64 * t * t * t * s * s * s, f1 = 192 * t * t * s * s * (s - t);
  const double f2 = 384 * t * s * (s * s - 3 * t * s + t * t);
  Blend<3> out;
  out.value = {f, f * t, f * t * t};
  out.first = {f1, f1 * t + f, f1 * t * t + 2 * f * t};
  out.second = {f2, f2 * t + 2 * f1, f2 * t * t + 4 * f1 * t + 2 * f};
  return out;
}

/// s^2 (1 - s)^3 / 2, away from a side.
Blend<1> depth_at(double s) {
  const double r = 1 - s;
  Blend<1> out;
  out.value = {0.5 * s * s * r * r * r};
  out.first = {s * r * r * r - 1.5 * s * s * r * r};
  out.second = {r * r * r - 6 * s * r * r + 3 * s * s * r};
  return out;
}

/// As functions of the parameter, where the side runs or lies the other way.
template <std::size_t N>
Blend<N> turned(Blend<N> of) {
  for (double& d : of.first) d = -d;
  return of;
}

/// Everything of one direction at a parameter.
struct Direction {
  double t;
  Blend<6> quintic;
  Blend<4> hermite;
  Blend<3> bump, bump_back;
  Blend<1> depth, depth_back;
  explicit Direction(double x)
      : t(x),
        quintic(quintic_at(x, 1 - x)),
        hermite(hermite_at(x)),
        bump(bump_at(x)),
        bump_back(turned(bump_at(1 - x))),
        depth(depth_at(x)),
        depth_back(turned(depth_at(1 - x))) {}
};

/// From both ends alike.
Vector3 sum(const std::array<double, 6>& w, const Quintic& c) {
  return (w[0] * c[0] + w[5] * c[5]) + (w[1] * c[1] + w[4] * c[4]) + (w[2] * c[2] + w[3] * c[3]);
}

/// The four curves of one direction (value, cross, cross, value) at a parameter.
struct Rails {
  std::array<Vector3, 4> value, first, second;
};
Rails rails(const Quintic& a, const Quintic& cross_a, const Quintic& cross_b, const Quintic& b,
            const Direction& at, Order order) {
  const auto all = [&](const std::array<double, 6>& w) {
    return std::array<Vector3, 4>{sum(w, a), sum(w, cross_a), sum(w, cross_b), sum(w, b)};
  };
  Rails out;
  out.value = all(at.quintic.value);
  out.first = all(at.quintic.first);
  if (order == Order::second) out.second = all(at.quintic.second);
  return out;
}

Vector3 rate(const Quintic& c, bool end) {
  return end ? Vector3(5 * (c[5] - c[4])) : Vector3(5 * (c[1] - c[0]));
}

/// The part that both blends count twice; twists are `constant` + x `share` with x = p / (p + q), p and q the
/// distances from the corner along u and v.
struct Corners {
  std::array<std::array<Vector3, 4>, 4> constant;
  std::array<std::array<Vector3, 2>, 2> share;
};
Corners corners_of(const HermitePatch& p) {
  Corners out;
  out.constant[0] = {p.c0[0], rate(p.e0, false), rate(p.e0, true), p.c1[0]};
  out.constant[3] = {p.c0[5], rate(p.e1, false), rate(p.e1, true), p.c1[5]};
  for (std::size_t i = 0; i < 2; ++i) {
    out.constant[1 + i][0] = rate(p.c0, i == 1);
    out.constant[1 + i][3] = rate(p.c1, i == 1);
    for (std::size_t j = 0; j < 2; ++j) {
      const Vector3 by_u = rate(i == 0 ? p.cross_e0 : p.cross_e1, j == 1);
      const Vector3 by_v = rate(j == 0 ? p.cross_c0 : p.cross_c1, i == 1);
      out.constant[1 + i][1 + j] = by_v;
      out.share[i][j] = by_u - by_v;
    }
  }
  return out;
}

/// p / (p + q) with derivatives; 1/2 at the corner, where its factor vanishes.
struct Ratio {
  double value, p, q, pp, pq, qq;
};
Ratio ratio(double p, double q) {
  const double s = p + q;
  if (!(s > 0)) return {0.5, 0, 0, 0, 0, 0};
  const double s2 = s * s, s3 = s2 * s;
  return {p / s, q / s2, -p / s2, -2 * q / s3, (p - q) / s3, 2 * p / s3};
}

void add_coons(const Corners& m, const Rails& e, const Rails& c, const Direction& u, const Direction& v,
               Order order, PatchPoint& out) {
  for (std::size_t k = 0; k < 4; ++k) {
    Vector3 row = e.value[k], row_v = e.first[k];
    for (std::size_t l = 0; l < 4; ++l) {
      row -= v.hermite.value[l] * m.constant[k][l];
      row_v -= v.hermite.first[l] * m.constant[k][l];
    }
    out.position += u.hermite.value[k] * row + v.hermite.value[k] * c.value[k];
    out.ds += u.hermite.first[k] * row + v.hermite.value[k] * c.first[k];
    out.dt += u.hermite.value[k] * row_v + v.hermite.first[k] * c.value[k];
    if (order != Order::second) continue;
    Vector3 row_vv = e.second[k];
    for (std::size_t l = 0; l < 4; ++l) row_vv -= v.hermite.second[l] * m.constant[k][l];
    out.dss += u.hermite.second[k] * row + v.hermite.value[k] * c.second[k];
    out.dst += u.hermite.first[k] * row_v + v.hermite.first[k] * c.first[k];
    out.dtt += u.hermite.value[k] * row_vv + v.hermite.second[k] * c.value[k];
  }
}

void add_twists(const Corners& m, const Direction& u, const Direction& v, Order order, PatchPoint& out) {
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const double su = i == 0 ? 1 : -1, sv = j == 0 ? 1 : -1;
      const Ratio x = ratio(i == 0 ? u.t : 1 - u.t, j == 0 ? v.t : 1 - v.t);
      const double xu = su * x.p, xv = sv * x.q;
      const double a = u.hermite.value[1 + i], au = u.hermite.first[1 + i], auu = u.hermite.second[1 + i];
      const double b = v.hermite.value[1 + j], bv = v.hermite.first[1 + j], bvv = v.hermite.second[1 + j];
      const Vector3& share = m.share[i][j];
      out.position -= a * b * x.value * share;
      out.ds -= b * (au * x.value + a * xu) * share;
      out.dt -= a * (bv * x.value + b * xv) * share;
      if (order != Order::second) continue;
      out.dss -= b * (auu * x.value + 2 * au * xu + a * x.pp) * share;
      out.dtt -= a * (bvv * x.value + 2 * bv * xv + b * x.qq) * share;
      out.dst -= (au * bv * x.value + au * b * xv + a * bv * xu + a * b * su * sv * x.pq) * share;
    }
}

/// One side's bend: `along` and `away` are of different directions.
void add_bend(const std::array<Vector3, 3>& bend, const Blend<3>& along, const Blend<1>& away, bool along_u,
              Order order, PatchPoint& out) {
  const auto at = [&](const std::array<double, 3>& w) -> Vector3 {
    return w[0] * bend[0] + w[1] * bend[1] + w[2] * bend[2];
  };
  const Vector3 value = at(along.value), first = at(along.first);
  out.position += away.value[0] * value;
  (along_u ? out.ds : out.dt) += away.value[0] * first;
  (along_u ? out.dt : out.ds) += away.first[0] * value;
  if (order != Order::second) return;
  (along_u ? out.dss : out.dtt) += away.value[0] * at(along.second);
  (along_u ? out.dtt : out.dss) += away.second[0] * value;
  out.dst += away.first[0] * first;
}

/// Sides are decided by the curve alone.
void set_side_position(const HermitePatch& p, const Direction& u, const Direction& v, PatchPoint& out) {
  if (v.t == 0)
    out.position = sum(u.quintic.value, p.c0);
  else if (u.t == 1)
    out.position = sum(v.quintic.value, p.e1);
  else if (v.t == 1)
    out.position = sum(u.quintic.value, p.c1);
  else if (u.t == 0)
    out.position = sum(v.quintic.value, p.e0);
}

PatchPoint point_at(const HermitePatch& p, const Corners& m, const Rails& across, const Rails& along,
                    const Direction& u, const Direction& v, Order order) {
  PatchPoint out;
  add_coons(m, across, along, u, v, order, out);
  add_twists(m, u, v, order, out);
  add_bend(p.bend[0], u.bump, v.depth, true, order, out);
  add_bend(p.bend[1], v.bump, u.depth_back, false, order, out);
  add_bend(p.bend[2], u.bump_back, v.depth_back, true, order, out);
  add_bend(p.bend[3], v.bump_back, u.depth, false, order, out);
  set_side_position(p, u, v, out);
  return out;
}

Rails rails_along(const HermitePatch& p, const Direction& u, Order order) {
  return rails(p.c0, p.cross_c0, p.cross_c1, p.c1, u, order);
}
Rails rails_across(const HermitePatch& p, const Direction& v, Order order) {
  return rails(p.e0, p.cross_e0, p.cross_e1, p.e1, v, order);
}

/// each(patch, parameter, point) for every point of the grid on every patch.
template <class Each>
void for_grid(const std::vector<HermitePatch>& all, std::span<const Index> patches,
              const GridPattern& pattern, Order order, const Each& each) {
  HARIKO_ASSERT(pattern.domain == Domain::square, "patches round solids are squares");
  const int n = pattern.density;
  std::vector<Direction> at;
  for (int i = 0; i <= n; ++i) at.emplace_back(grid_fraction(i, n));
  std::vector<Rails> along(at.size());
  for (const Index index : patches) {
    const HermitePatch& patch = all[index];
    const Corners corners = corners_of(patch);
    for (std::size_t i = 0; i < at.size(); ++i) along[i] = rails_along(patch, at[i], order);
    for (const Direction& v : at) {
      const Rails across = rails_across(patch, v, order);
      for (std::size_t i = 0; i < at.size(); ++i)
        each(index, Vector2(at[i].t, v.t), point_at(patch, corners, across, along[i], at[i], v, order));
    }
  }
}

}  // namespace

Vector3 value_at(const Quintic& curve, double t) {
  return sum(quintic_at(t, 1 - t).value, curve);
}

Vector3 derivative_at(const Quintic& curve, double t) {
  return sum(quintic_at(t, 1 - t).first, curve);
}

Quintic reversed(const Quintic& c) {
  return {c[5], c[4], c[3], c[2], c[1], c[0]};
}

HermitePatch HermitePatch::from_loop(const std::array<Quintic, 4>& sides,
                                     const std::array<Quintic, 4>& inwards) {
  const auto negative = [](Quintic of) {
    for (Vector3& p : of) p = -p;
    return of;
  };
  HermitePatch out;
  out.c0 = sides[0];
  out.e1 = sides[1];
  out.c1 = reversed(sides[2]);
  out.e0 = reversed(sides[3]);
  out.cross_c0 = inwards[0];
  out.cross_e1 = negative(inwards[1]);
  out.cross_c1 = negative(reversed(inwards[2]));
  out.cross_e0 = reversed(inwards[3]);
  return out;
}

PatchPoint evaluate(const HermitePatch& patch, const Vector2& parameter, Order order) {
  const Direction u(parameter.x()), v(parameter.y());
  return point_at(patch, corners_of(patch), rails_across(patch, v, order), rails_along(patch, u, order), u, v,
                  order);
}

PatchPoint HermitePatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  return hariko::evaluate(patches_[patch], parameter, order);
}

void HermitePatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                    std::span<PatchPoint> points) const {
  HARIKO_ASSERT(points.size() >= patches.size() * std::size_t(pattern.point_count()),
                "output array is too small");
  std::size_t at = 0;
  for_grid(patches_, patches, pattern, Order::second,
           [&](Index, const Vector2&, const PatchPoint& point) { points[at++] = point; });
}

void HermitePatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                    std::span<Vector3> positions, std::span<Vector3> normals) const {
  const Vector2 middle(0.5, 0.5);
  std::size_t at = 0;
  for_grid(patches_, patches, pattern, Order::first,
           [&](Index patch, const Vector2& parameter, const PatchPoint& point) {
             positions[at] = point.position;
             normals[at] = unit_normal(point);
             if (normals[at].isZero(0))
               normals[at] =
                   unit_normal(evaluate(patch, parameter + 1e-4 * (middle - parameter), Order::first));
             ++at;
           });
}

CornerSecondOrder HermitePatchSet::second_order_at_corner(Index at, int corner) const {
  return unit_normal(evaluate(at, corner_parameter(Domain::square, corner), Order::first)).isZero(0)
             ? CornerSecondOrder::undefined
             : CornerSecondOrder::direction_dependent;
}

}  // namespace hariko

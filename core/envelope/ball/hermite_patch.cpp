#include "core/envelope/ball/hermite_patch.hpp"

namespace hariko {

namespace {

using gregory::Blend;

/// Bump functions 64 t^3 (1 - t)^3 (1, t, t^2) along a side.
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

/// Factor s^2 (1 - s)^3 / 2 at distance s from a side.
Blend<1> depth_at(double s) {
  const double r = 1 - s;
  Blend<1> out;
  out.value = {0.5 * s * s * r * r * r};
  out.first = {s * r * r * r - 1.5 * s * s * r * r};
  out.second = {r * r * r - 6 * s * r * r + 3 * s * s * r};
  return out;
}

/// Derivatives by the patch's parameter where the side runs in the opposite direction.
template <std::size_t N>
Blend<N> turned(Blend<N> of) {
  for (double& d : of.first) d = -d;
  return of;
}

/// All basis functions of one direction at a parameter.
struct Direction {
  double t;
  Blend<6> quintic;
  Blend<4> hermite;
  Blend<3> bump, bump_back;
  Blend<1> depth, depth_back;
  explicit Direction(double x)
      : t(x),
        quintic(gregory::bernstein_at<6>(x, 1 - x)),
        hermite(gregory::hermite_at(x)),
        bump(bump_at(x)),
        bump_back(turned(bump_at(1 - x))),
        depth(depth_at(x)),
        depth_back(turned(depth_at(1 - x))) {}
};

using Rails = gregory::Rails<Vector3>;
using Corners = gregory::Corners<Vector3>;

/// Adds one side's bend: `along` and `away` belong to different directions.
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

/// Sets positions on sides from the side's curve alone.
void set_side_position(const HermitePatch& p, const Direction& u, const Direction& v, PatchPoint& out) {
  if (v.t == 0)
    out.position = gregory::sum(u.quintic.value, p.c0);
  else if (u.t == 1)
    out.position = gregory::sum(v.quintic.value, p.e1);
  else if (v.t == 1)
    out.position = gregory::sum(u.quintic.value, p.c1);
  else if (u.t == 0)
    out.position = gregory::sum(v.quintic.value, p.e0);
}

PatchPoint point_at(const HermitePatch& p, const Corners& m, const Rails& across, const Rails& along,
                    const Direction& u, const Direction& v, Order order) {
  gregory::Jet<Vector3> jet = gregory::coons(m, across, along, u.hermite, v.hermite, order);
  gregory::subtract_twists(m, u.t, u.hermite, v.t, v.hermite, order, jet);
  PatchPoint out{jet.value, jet.u, jet.v, jet.uu, jet.uv, jet.vv};
  add_bend(p.bend[0], u.bump, v.depth, true, order, out);
  add_bend(p.bend[1], v.bump, u.depth_back, false, order, out);
  add_bend(p.bend[2], u.bump_back, v.depth_back, true, order, out);
  add_bend(p.bend[3], v.bump_back, u.depth, false, order, out);
  set_side_position(p, u, v, out);
  return out;
}

Rails rails_along(const HermitePatch& p, const Direction& u, Order order) {
  return gregory::rails(p.c0, p.cross_c0, p.cross_c1, p.c1, u.quintic, u.quintic, order);
}
Rails rails_across(const HermitePatch& p, const Direction& v, Order order) {
  return gregory::rails(p.e0, p.cross_e0, p.cross_e1, p.e1, v.quintic, v.quintic, order);
}

}  // namespace

Vector3 value_at(const Quintic& curve, double t) {
  return gregory::sum(gregory::bernstein_at<6>(t, 1 - t).value, curve);
}

Vector3 derivative_at(const Quintic& curve, double t) {
  return gregory::sum(gregory::bernstein_at<6>(t, 1 - t).first, curve);
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
  return point_at(patch, gregory::corners_of(patch), rails_across(patch, v, order),
                  rails_along(patch, u, order), u, v, order);
}

SideEvaluation side_evaluation(std::span<const double> fractions) {
  struct Bases {
    Direction start{0.0}, end{1.0};
    std::vector<Direction> onwards, backwards;  ///< at the fractions from either end
  } made;
  for (const double t : fractions) {
    made.onwards.emplace_back(t);
    made.backwards.emplace_back(1.0 - t);
  }
  return [at = std::move(made)](const HermitePatch& p, std::span<PatchPoint> points) {
    const std::size_t n = at.onwards.size();
    HARIKO_ASSERT(points.size() >= 4 * n, "output array is too small");
    constexpr Order order = Order::second;
    const Corners corners = gregory::corners_of(p);
    const Rails across_start = rails_across(p, at.start, order), across_end = rails_across(p, at.end, order);
    const Rails along_start = rails_along(p, at.start, order), along_end = rails_along(p, at.end, order);
    for (std::size_t i = 0; i < n; ++i) {
      const Direction &on = at.onwards[i], &back = at.backwards[i];
      points[i] = point_at(p, corners, across_start, rails_along(p, on, order), on, at.start, order);
      points[n + i] = point_at(p, corners, rails_across(p, on, order), along_end, at.end, on, order);
      points[2 * n + i] = point_at(p, corners, across_end, rails_along(p, back, order), back, at.end, order);
      points[3 * n + i] =
          point_at(p, corners, rails_across(p, back, order), along_start, at.start, back, order);
    }
  };
}

PatchPoint HermitePatchSet::evaluate(Index patch, const Vector2& parameter, Order order) const {
  return hariko::evaluate(patches_[patch], parameter, order);
}

void HermitePatchSet::for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                               const EachPoint& each) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "patches round solids are squares");
  const int n = pattern.density;
  std::vector<Direction> at;
  for (int i = 0; i <= n; ++i) at.emplace_back(grid_fraction(i, n));
  std::vector<Rails> along(at.size());
  for (const Index index : patches) {
    const HermitePatch& patch = patches_[index];
    const Corners corners = gregory::corners_of(patch);
    for (std::size_t i = 0; i < at.size(); ++i) along[i] = rails_along(patch, at[i], order);
    for (const Direction& v : at) {
      const Rails across = rails_across(patch, v, order);
      for (std::size_t i = 0; i < at.size(); ++i)
        each(index, Vector2(at[i].t, v.t), point_at(patch, corners, across, along[i], at[i], v, order));
    }
  }
}

}  // namespace hariko

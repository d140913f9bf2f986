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

using Corners = gregory::Corners<Vector3>;

/// Bend of a side at a place along it, with derivatives.
struct BendAt {
  Vector3 value, first, second;
  BendAt(const std::array<Vector3, 3>& bend, const Blend<3>& along)
      : value(at(bend, along.value)), first(at(bend, along.first)), second(at(bend, along.second)) {}

 private:
  static Vector3 at(const std::array<Vector3, 3>& bend, const std::array<double, 3>& w) {
    return w[0] * bend[0] + w[1] * bend[1] + w[2] * bend[2];
  }
};

/// Adds one side's bend: `along` and `away` belong to different directions.
void add_bend(const BendAt& along, const Blend<1>& away, bool along_u, Order order, PatchPoint& out) {
  out.position += away.value[0] * along.value;
  (along_u ? out.ds : out.dt) += away.value[0] * along.first;
  (along_u ? out.dt : out.ds) += away.first[0] * along.value;
  if (order != Order::second) return;
  (along_u ? out.dss : out.dtt) += away.value[0] * along.second;
  (along_u ? out.dtt : out.dss) += away.second[0] * along.value;
  out.dst += away.first[0] * along.first;
}

/// Part of a patch that all points with one u, or with one v, have in common.
struct Line {
  gregory::Rails<Vector3> rails;
  std::array<BendAt, 2> bends;
};

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

PatchPoint point_at(const HermitePatch& p, const Corners& m, const Line& across, const Line& along,
                    const Direction& u, const Direction& v, const gregory::TwistFactors& twists,
                    Order order) {
  gregory::Jet<Vector3> jet = gregory::coons(across.rails, along.rails, u.hermite, v.hermite, order);
  gregory::subtract_twists(m, twists, order, jet);
  PatchPoint out{jet.value, jet.u, jet.v, jet.uu, jet.uv, jet.vv};
  add_bend(along.bends[0], v.depth, true, order, out);
  add_bend(across.bends[0], u.depth_back, false, order, out);
  add_bend(along.bends[1], v.depth_back, true, order, out);
  add_bend(across.bends[1], u.depth, false, order, out);
  set_side_position(p, u, v, out);
  return out;
}

Line line_along(const HermitePatch& p, const Direction& u, Order order) {
  return {gregory::rails(p.c0, p.cross_c0, p.cross_c1, p.c1, u.quintic, u.quintic, order),
          {BendAt(p.bend[0], u.bump), BendAt(p.bend[2], u.bump_back)}};
}
Line line_across(const HermitePatch& p, const Corners& m, const Direction& v, Order order) {
  const auto rails = gregory::rails(p.e0, p.cross_e0, p.cross_e1, p.e1, v.quintic, v.quintic, order);
  return {gregory::row_at(m, rails, v.hermite, order),
          {BendAt(p.bend[1], v.bump), BendAt(p.bend[3], v.bump_back)}};
}

gregory::TwistFactors twists_at(const Direction& u, const Direction& v) {
  return gregory::twist_factors(u.t, u.hermite, v.t, v.hermite);
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

std::array<Vector3, 3> seconds_across(const HermitePatch& p) {
  static const Direction start(0.0);
  struct Place {
    Direction u;
    gregory::TwistFactors twists;
    explicit Place(double t) : u(t), twists(twists_at(u, start)) {}
  };
  static const std::array<Place, 3> places{Place(bend_places[0]), Place(bend_places[1]),
                                           Place(bend_places[2])};
  const Corners m = gregory::corners_of(p);
  const Line across = line_across(p, m, start, Order::second);
  std::array<Vector3, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [u, twists] = places[i];
    const std::array<const Quintic*, 4> along{&p.c0, &p.cross_c0, &p.cross_c1, &p.c1};
    out[i] = Vector3::Zero();
    for (std::size_t k = 0; k < 4; ++k)
      out[i] += u.hermite.value[k] * across.rails.second[k] +
                start.hermite.second[k] * gregory::sum(u.quintic.value, *along[k]);
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b) out[i] -= twists.at[a][b].vv * m.share[a][b];
  }
  return out;
}

std::array<Vector3, 3> bend_through(const std::array<Vector3, 3>& changes) {
  std::array<Vector3, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = changes[i] / bump_at(bend_places[i]).value[0];
  // Parabola through values at -1, 0, 1 of (t - 1/2) / 0.3.
  const double scale = 1 / (bend_places[2] - bend_places[1]), shift = -bend_places[1] * scale;
  const Vector3 c1 = 0.5 * (at[2] - at[0]), c2 = 0.5 * (at[2] + at[0]) - at[1];
  return {at[1] + shift * c1 + shift * shift * c2, scale * c1 + 2 * scale * shift * c2, scale * scale * c2};
}

PatchPoint HermitePatchSet::evaluate(Index index, const Vector2& parameter, Order order) const {
  const HermitePatch& patch = patches_[index];
  const Corners corners = gregory::corners_of(patch);
  const Direction u(parameter.x()), v(parameter.y());
  return point_at(patch, corners, line_across(patch, corners, v, order), line_along(patch, u, order), u, v,
                  twists_at(u, v), order);
}

void HermitePatchSet::for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                               const EachPoint& each) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "patches round solids are squares");
  const int n = pattern.density;
  std::vector<Direction> at;
  for (int i = 0; i <= n; ++i) at.emplace_back(grid_fraction(i, n));
  std::vector<gregory::TwistFactors> twists;
  for (const Direction& v : at)
    for (const Direction& u : at) twists.push_back(twists_at(u, v));
  std::vector<Line> along;
  for (const Index index : patches) {
    const HermitePatch& patch = patches_[index];
    const Corners corners = gregory::corners_of(patch);
    along.clear();
    for (const Direction& u : at) along.push_back(line_along(patch, u, order));
    auto twist = twists.begin();
    for (const Direction& v : at) {
      const Line across = line_across(patch, corners, v, order);
      for (std::size_t i = 0; i < at.size(); ++i)
        each(index, Vector2(at[i].t, v.t),
             point_at(patch, corners, across, along[i], at[i], v, *twist++, order));
    }
  }
}

}  // namespace hariko

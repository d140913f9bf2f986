#include "core/envelope/network/envelope_patch.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.hpp"
#include "core/envelope/gregory.hpp"

namespace hariko {

namespace {

/// All basis functions of one direction at a parameter.
struct Direction {
  double t;
  gregory::Blend<4> cubic, hermite;
  gregory::Blend<7> sextic;
  explicit Direction(double x)
      : t(x),
        cubic(gregory::bernstein_at<4>(x, 1 - x)),
        hermite(gregory::hermite_at(x)),
        sextic(gregory::bernstein_at<7>(x, 1 - x)) {}
};

using Rails = gregory::Rails<Homogeneous>;
using Corners = gregory::Corners<Homogeneous>;

gregory::Jet<Homogeneous> homogeneous_jet(const Corners& m, const Rails& across, const Rails& along,
                                          const Direction& u, const Direction& v, Order order) {
  gregory::Jet<Homogeneous> out = gregory::coons(m, across, along, u.hermite, v.hermite, order);
  gregory::subtract_twists(m, u.t, u.hermite, v.t, v.hermite, order, out);
  return out;
}

/// Cartesian point of a homogeneous one. `scale`: derivative of the patch's parameters by those of the part.
PatchPoint cartesian_point(const gregory::Jet<Homogeneous>& h, double scale, Order order) {
  PatchPoint out;
  const double w = h.value.w();
  out.position = h.value.head<3>() / w;
  out.ds = scale / w * (h.u.head<3>() - out.position * h.u.w());
  out.dt = scale / w * (h.v.head<3>() - out.position * h.v.w());
  if (order != Order::second) return out;
  const double square = scale * scale;
  out.dss = (square * (h.uu.head<3>() - out.position * h.uu.w()) - 2 * scale * h.u.w() * out.ds) / w;
  out.dtt = (square * (h.vv.head<3>() - out.position * h.vv.w()) - 2 * scale * h.v.w() * out.dt) / w;
  out.dst =
      (square * (h.uv.head<3>() - out.position * h.uv.w()) - scale * (h.v.w() * out.ds + h.u.w() * out.dt)) /
      w;
  return out;
}

/// Preferred derivative across the middle of a side, from the chord between the midpoints of two opposite
/// sides.
Vector3 wanted(const RibbonCurve& side, const Vector3& chord, double fullness) {
  const Vector3 across = 0.5 * (side.across[0] + side.across[1]);
  const Vector3 n = side.middle_derivative().cross(across).stableNormalized();
  const Vector3 r = chord - chord.dot(n) * n;
  return r.stableNormalized() * (chord.norm() * fullness);
}

double speed_ratio(const Vector3& derivative, const RibbonCurve& side) {
  const double chord = (side.end() - side.start()).norm();
  return chord > 0 ? derivative.norm() / chord : 1;
}

}  // namespace

EnvelopePatch EnvelopePatch::from_loop(const std::array<RibbonCurve, 4>& loop) {
  const RibbonCurve &c0 = loop[0], &e1 = loop[1];
  const RibbonCurve c1 = loop[2].reversed(), e0 = loop[3].reversed();
  const Vector3 along_v = c1.middle() - c0.middle(), along_u = e1.middle() - e0.middle();
  const double f_c0 = 0.5 * (speed_ratio(e0.start_derivative(), e0) + speed_ratio(e1.start_derivative(), e1));
  const double f_c1 = 0.5 * (speed_ratio(e0.end_derivative(), e0) + speed_ratio(e1.end_derivative(), e1));
  const double f_e0 = 0.5 * (speed_ratio(c0.start_derivative(), c0) + speed_ratio(c1.start_derivative(), c1));
  const double f_e1 = 0.5 * (speed_ratio(c0.end_derivative(), c0) + speed_ratio(c1.end_derivative(), c1));
  const auto field = [](const RibbonCurve& side, const Homogeneous& start, const Homogeneous& end,
                        const Vector3& middle) {
    return cross_field(side, cross_coefficients(side, start, end, middle));
  };
  EnvelopePatch out{c0.curve, e1.curve, c1.curve, e0.curve, {}, {}, {}, {}};
  out.cross_c0 = field(c0, e0.start_rate(), e1.start_rate(), wanted(c0, along_v, f_c0));
  out.cross_c1 = field(c1, e0.end_rate(), e1.end_rate(), wanted(c1, along_v, f_c1));
  out.cross_e0 = field(e0, c0.start_rate(), c1.start_rate(), wanted(e0, along_u, f_e0));
  out.cross_e1 = field(e1, c0.end_rate(), c1.end_rate(), wanted(e1, along_u, f_e1));
  return out;
}

/// Patch of a part, with terms shared by its points.
struct EnvelopePatchSet::Frame {
  const Part& part;
  const EnvelopePatch& patch;
  Corners corners;

  Rails across_u(const Direction& v) const {
    return gregory::rails(patch.e0, patch.cross_e0, patch.cross_e1, patch.e1, v.cubic, v.sextic,
                          Order::second);
  }
  Rails across_v(const Direction& u) const {
    return gregory::rails(patch.c0, patch.cross_c0, patch.cross_c1, patch.c1, u.cubic, u.sextic,
                          Order::second);
  }
  /// Sets points of outer sides from the curve alone, so that both patches give the same bits.
  void set_side_position(double s, double t, PatchPoint& point) const {
    const auto set = [&](std::size_t side, double x) {
      if (!part.sides[side].outer) return false;
      const Homogeneous at = gregory::sum(gregory::bernstein_values<4>(x, 1 - x), part.sides[side].curve);
      point.position = cartesian(at);
      return true;
    };
    if (t == 0 && set(0, s)) return;
    if (s == 1 && set(1, t)) return;
    if (t == 1 && set(2, 1 - s)) return;
    if (s == 0) set(3, 1 - t);
  }
};

EnvelopePatchSet::EnvelopePatchSet(std::vector<EnvelopePatch> patches, std::vector<Part> parts)
    : patches_(std::move(patches)), parts_(std::move(parts)) {
  for (const Part& part : parts_)
    HARIKO_ASSERT(part.part.patch < patches_.size(), "a part of a patch that does not exist");
}

PatchPoint EnvelopePatchSet::evaluate(Index at, const Vector2& parameter, Order order) const {
  const Part& part = parts_[at];
  const EnvelopePatch& patch = patches_[part.part.patch];
  const Frame frame{part, patch, gregory::corners_of(patch)};
  const Direction u(part.part.u0 + part.part.size * parameter.x()),
      v(part.part.v0 + part.part.size * parameter.y());
  PatchPoint out =
      cartesian_point(homogeneous_jet(frame.corners, frame.across_u(v), frame.across_v(u), u, v, order),
                      part.part.size, order);
  frame.set_side_position(parameter.x(), parameter.y(), out);
  return out;
}

/// Calls each(patch, parameter, point) for every point of the grid on every patch.
template <class Each>
void EnvelopePatchSet::for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                                const Each& each) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "patches of envelopes are squares");
  const int n = pattern.density;
  for (const Index index : patches) {
    const Part& part = parts_[index];
    const EnvelopePatch& patch = patches_[part.part.patch];
    const Frame frame{part, patch, gregory::corners_of(patch)};
    std::vector<Direction> us;
    std::vector<Rails> along;
    for (int i = 0; i <= n; ++i) {
      us.emplace_back(part.part.u0 + part.part.size * grid_fraction(i, n));
      along.push_back(frame.across_v(us.back()));
    }
    for (int j = 0; j <= n; ++j) {
      const double t = grid_fraction(j, n);
      const Direction v(part.part.v0 + part.part.size * t);
      const Rails across = frame.across_u(v);
      for (int i = 0; i <= n; ++i) {
        const auto k = std::size_t(i);
        const double s = grid_fraction(i, n);
        PatchPoint point = cartesian_point(homogeneous_jet(frame.corners, across, along[k], us[k], v, order),
                                           part.part.size, order);
        frame.set_side_position(s, t, point);
        each(index, Vector2(s, t), point);
      }
    }
  }
}

void EnvelopePatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                     std::span<PatchPoint> points) const {
  HARIKO_ASSERT(points.size() >= patches.size() * std::size_t(pattern.point_count()),
                "output array is too small");
  std::size_t at = 0;
  for_grid(patches, pattern, Order::second,
           [&](Index, const Vector2&, const PatchPoint& point) { points[at++] = point; });
}

void EnvelopePatchSet::evaluate_grid(std::span<const Index> patches, const GridPattern& pattern,
                                     std::span<Vector3> positions, std::span<Vector3> normals) const {
  std::size_t at = 0;
  for_grid(patches, pattern, Order::first,
           [&](Index patch, const Vector2& parameter, const PatchPoint& point) {
             positions[at] = point.position;
             normals[at++] = normal_at(patch, parameter, point);
           });
}

CornerSecondOrder EnvelopePatchSet::second_order_at_corner(Index at, int corner) const {
  const EnvelopePart& part = parts_[at].part;
  const Vector2 local = corner_parameter(Domain::square, corner);
  const double u = part.u0 + part.size * local.x(), v = part.v0 + part.size * local.y();
  if ((u != 0 && u != 1) || (v != 0 && v != 1)) return CornerSecondOrder::exact;
  return unit_normal(evaluate(at, local, Order::first)).isZero(0) ? CornerSecondOrder::undefined
                                                                  : CornerSecondOrder::direction_dependent;
}

}  // namespace hariko

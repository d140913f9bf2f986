#include "core/envelope/network/envelope_patch.hpp"

#include <Eigen/Geometry>

namespace hariko {

namespace {

/// All basis functions of one direction at a parameter.
struct SexticDirection {
  double t;
  gregory::Blend<4> cubic, hermite;
  gregory::Blend<7> sextic;
  explicit SexticDirection(double x)
      : t(x),
        cubic(gregory::bernstein_at<4>(x, 1 - x)),
        hermite(gregory::hermite_at(x)),
        sextic(gregory::bernstein_at<7>(x, 1 - x)) {}
};

using Rails = gregory::Rails<Homogeneous>;
using HomogeneousCorners = gregory::Corners<Homogeneous>;

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

/// Patch of a part, with terms shared by its points.
struct PartFrame {
  const EnvelopePart& part;
  const EnvelopePatch& patch;
  HomogeneousCorners corners = gregory::corners_of(patch);

  SexticDirection along_u(double s) const { return SexticDirection(part.u0 + part.size * s); }
  SexticDirection along_v(double t) const { return SexticDirection(part.v0 + part.size * t); }
  Rails across_u(const SexticDirection& v) const {
    const Rails across =
        gregory::rails(patch.e0, patch.cross_e0, patch.cross_e1, patch.e1, v.cubic, v.sextic, Order::second);
    return gregory::row_at(corners, across, v.hermite, Order::second);
  }
  Rails across_v(const SexticDirection& u) const {
    return gregory::rails(patch.c0, patch.cross_c0, patch.cross_c1, patch.c1, u.cubic, u.sextic,
                          Order::second);
  }
  /// Point at (s, t) of the part.
  PatchPoint point(double s, const SexticDirection& u, const Rails& along, double t, const SexticDirection& v,
                   const Rails& across, Order order) const {
    gregory::Jet<Homogeneous> jet = gregory::coons(across, along, u.hermite, v.hermite, order);
    gregory::subtract_twists(corners, gregory::twist_factors(u.t, u.hermite, v.t, v.hermite), order, jet);
    PatchPoint out = cartesian_point(jet, part.size, order);
    // On outer sides from the curve alone, so that both patches give the same bits.
    const auto set = [&](std::size_t side, double x) {
      if (!part.sides[side]) return false;
      const Homogeneous at = gregory::sum(gregory::bernstein_values<4>(x, 1 - x), *part.sides[side]);
      out.position = cartesian(at);
      return true;
    };
    const bool found = (t == 0 && set(0, s)) || (s == 1 && set(1, t)) || (t == 1 && set(2, 1 - s));
    if (!found && s == 0) set(3, 1 - t);
    return out;
  }
};

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

EnvelopePatchSet::EnvelopePatchSet(std::vector<EnvelopePatch> patches, std::vector<EnvelopePart> parts)
    : patches_(std::move(patches)), parts_(std::move(parts)) {
  for (const EnvelopePart& part : parts_)
    HARIKO_ASSERT(part.patch < patches_.size(), "a part of a patch that does not exist");
}

PatchPoint EnvelopePatchSet::evaluate(Index at, const Vector2& parameter, Order order) const {
  const PartFrame frame{parts_[at], patches_[parts_[at].patch]};
  const SexticDirection u = frame.along_u(parameter.x()), v = frame.along_v(parameter.y());
  return frame.point(parameter.x(), u, frame.across_v(u), parameter.y(), v, frame.across_u(v), order);
}

void EnvelopePatchSet::for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                                const EachPoint& each) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "patches of envelopes are squares");
  const int n = pattern.density;
  for (const Index index : patches) {
    const PartFrame frame{parts_[index], patches_[parts_[index].patch]};
    std::vector<SexticDirection> us;
    std::vector<Rails> along;
    for (int i = 0; i <= n; ++i) {
      us.push_back(frame.along_u(grid_fraction(i, n)));
      along.push_back(frame.across_v(us.back()));
    }
    for (int j = 0; j <= n; ++j) {
      const double t = grid_fraction(j, n);
      const SexticDirection v = frame.along_v(t);
      const Rails across = frame.across_u(v);
      for (int i = 0; i <= n; ++i) {
        const auto k = std::size_t(i);
        const double s = grid_fraction(i, n);
        each(index, Vector2(s, t), frame.point(s, us[k], along[k], t, v, across, order));
      }
    }
  }
}

CornerSecondOrder EnvelopePatchSet::second_order_at_corner(Index at, int corner) const {
  const EnvelopePart& part = parts_[at];
  const Vector2 local = corner_parameter(Domain::square, corner);
  const double u = part.u0 + part.size * local.x(), v = part.v0 + part.size * local.y();
  if ((u != 0 && u != 1) || (v != 0 && v != 1)) return CornerSecondOrder::exact;
  return GridPatchSet::second_order_at_corner(at, corner);
}

}  // namespace hariko

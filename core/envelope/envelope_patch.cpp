#include "core/envelope/envelope_patch.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

template <std::size_t N>
struct Polynomials {
  std::array<double, N> value, first, second;
};

/// Bernstein polynomials, the same bits from either end.
template <std::size_t N>
std::array<double, N> bernstein_values(double x, double y) {
  constexpr auto choose = [](std::size_t n, std::size_t k) {
    double out = 1;
    for (std::size_t i = 0; i < k; ++i) out = out * double(n - i) / double(i + 1);
    return out;
  };
  std::array<double, N> px, py, out;
  px[0] = py[0] = 1;
  for (std::size_t i = 1; i < N; ++i) px[i] = px[i - 1] * x, py[i] = py[i - 1] * y;
  for (std::size_t i = 0; i < N; ++i) out[i] = choose(N - 1, i) * (px[i] * py[N - 1 - i]);
  return out;
}
template <std::size_t N>
Polynomials<N> bernstein_at(double x) {
  const double y = 1 - x;
  Polynomials<N> out;
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

/// Blends of value, derivative, derivative, value.
Polynomials<4> hermite_at(double t) {
  Polynomials<4> out;
  out.value = {1 - 3 * t * t + 2 * t * t * t, t - 2 * t * t + t * t * t, t * t * t - t * t,
               3 * t * t - 2 * t * t * t};
  out.first = {-6 * t + 6 * t * t, 1 - 4 * t + 3 * t * t, 3 * t * t - 2 * t, 6 * t - 6 * t * t};
  out.second = {-6 + 12 * t, -4 + 6 * t, 6 * t - 2, 6 - 12 * t};
  return out;
}

/// Everything of a direction at one parameter.
struct Direction {
  double t;
  Polynomials<4> cubic, hermite;
  Polynomials<7> sextic;
  explicit Direction(double x)
      : t(x), cubic(bernstein_at<4>(x)), hermite(hermite_at(x)), sextic(bernstein_at<7>(x)) {}
};

template <std::size_t N>
Homogeneous sum(const std::array<double, N>& weight, const std::array<Homogeneous, N>& point) {
  Homogeneous out = weight[0] * point[0];
  for (std::size_t i = 1; i < N; ++i) out += weight[i] * point[i];
  return out;
}

/// The four curves of one direction (value, cross, cross, value) at a parameter, with derivatives.
struct Rails {
  std::array<Homogeneous, 4> value, first, second;
};
Rails rails(const HomogeneousCubic& a, const HomogeneousSextic& cross_a, const HomogeneousSextic& cross_b,
            const HomogeneousCubic& b, const Direction& at) {
  return {{sum(at.cubic.value, a), sum(at.sextic.value, cross_a), sum(at.sextic.value, cross_b),
           sum(at.cubic.value, b)},
          {sum(at.cubic.first, a), sum(at.sextic.first, cross_a), sum(at.sextic.first, cross_b),
           sum(at.cubic.first, b)},
          {sum(at.cubic.second, a), sum(at.sextic.second, cross_a), sum(at.sextic.second, cross_b),
           sum(at.cubic.second, b)}};
}

/// The corner terms M, twists without the variable share, and that share: T = constant + x share with
/// x = p / (p + q), p and q the distances from the corner along u and v.
struct Corners {
  std::array<std::array<Homogeneous, 4>, 4> constant;
  std::array<std::array<Homogeneous, 2>, 2> share;
};
Corners corners_of(const EnvelopePatch& p) {
  const auto rate = [](const auto& c, bool end) -> Homogeneous {
    const double n = double(c.size() - 1);
    return end ? Homogeneous(n * (c[c.size() - 1] - c[c.size() - 2])) : Homogeneous(n * (c[1] - c[0]));
  };
  Corners out;
  out.constant[0] = {p.c0[0], rate(p.e0, false), rate(p.e0, true), p.c1[0]};
  out.constant[3] = {p.c0[3], rate(p.e1, false), rate(p.e1, true), p.c1[3]};
  const std::array<Homogeneous, 2> start{rate(p.c0, false), rate(p.c1, false)},
      end{rate(p.c0, true), rate(p.c1, true)};
  for (std::size_t i = 0; i < 2; ++i) {
    out.constant[1 + i][0] = i == 0 ? start[0] : end[0];
    out.constant[1 + i][3] = i == 0 ? start[1] : end[1];
    for (std::size_t j = 0; j < 2; ++j) {
      const Homogeneous by_u = rate(i == 0 ? p.cross_e0 : p.cross_e1, j == 1);
      const Homogeneous by_v = rate(j == 0 ? p.cross_c0 : p.cross_c1, i == 1);
      out.constant[1 + i][1 + j] = by_v;
      out.share[i][j] = by_u - by_v;
    }
  }
  return out;
}

/// p / (p + q) with derivatives by p and q; 1/2 at the corner, where its factor vanishes.
struct Ratio {
  double value, p, q, pp, pq, qq;
};
Ratio ratio(double p, double q) {
  const double s = p + q;
  if (!(s > 0)) return {0.5, 0, 0, 0, 0, 0};
  const double s2 = s * s, s3 = s2 * s;
  return {p / s, q / s2, -p / s2, -2 * q / s3, (p - q) / s3, 2 * p / s3};
}

struct HomogeneousPoint {
  Homogeneous value, u, v, uu, uv, vv;
};

HomogeneousPoint homogeneous_point(const Corners& m, const Rails& e, const Rails& c, const Direction& u,
                                   const Direction& v, Order order) {
  const bool second = order == Order::second;
  HomogeneousPoint out;
  out.value = out.u = out.v = out.uu = out.uv = out.vv = Homogeneous::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    Homogeneous row = e.value[k], row_v = e.first[k], row_vv = e.second[k];
    for (std::size_t l = 0; l < 4; ++l) {
      row -= v.hermite.value[l] * m.constant[k][l];
      row_v -= v.hermite.first[l] * m.constant[k][l];
      if (second) row_vv -= v.hermite.second[l] * m.constant[k][l];
    }
    out.value += u.hermite.value[k] * row + v.hermite.value[k] * c.value[k];
    out.u += u.hermite.first[k] * row + v.hermite.value[k] * c.first[k];
    out.v += u.hermite.value[k] * row_v + v.hermite.first[k] * c.value[k];
    if (!second) continue;
    out.uu += u.hermite.second[k] * row + v.hermite.value[k] * c.second[k];
    out.uv += u.hermite.first[k] * row_v + v.hermite.first[k] * c.first[k];
    out.vv += u.hermite.value[k] * row_vv + v.hermite.second[k] * c.value[k];
  }
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const double su = i == 0 ? 1 : -1, sv = j == 0 ? 1 : -1;
      const Ratio x = ratio(i == 0 ? u.t : 1 - u.t, j == 0 ? v.t : 1 - v.t);
      const double xu = su * x.p, xv = sv * x.q;
      const double a = u.hermite.value[1 + i], au = u.hermite.first[1 + i], auu = u.hermite.second[1 + i];
      const double b = v.hermite.value[1 + j], bv = v.hermite.first[1 + j], bvv = v.hermite.second[1 + j];
      const Homogeneous& share = m.share[i][j];
      out.value -= a * b * x.value * share;
      out.u -= b * (au * x.value + a * xu) * share;
      out.v -= a * (bv * x.value + b * xv) * share;
      if (!second) continue;
      out.uu -= b * (auu * x.value + 2 * au * xu + a * x.pp) * share;
      out.vv -= a * (bvv * x.value + 2 * bv * xv + b * x.qq) * share;
      out.uv -= (au * bv * x.value + au * b * xv + a * bv * xu + a * b * su * sv * x.pq) * share;
    }
  return out;
}

/// `scale`: derivative of the patch's parameters by those of the part.
PatchPoint cartesian_point(const HomogeneousPoint& h, double scale, Order order) {
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

/// The middle derivative that a side wants, from the chord between the middles of two facing sides (spec 4).
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

EnvelopePatch EnvelopePatch::from_loop(const std::array<RibbonCurve, 4>& loop, double slide) {
  const RibbonCurve &c0 = loop[0], &e1 = loop[1];
  const RibbonCurve c1 = loop[2].reversed(), e0 = loop[3].reversed();
  const Vector3 along_v = c1.middle() - c0.middle(), along_u = e1.middle() - e0.middle();
  const double f_c0 = 0.5 * (speed_ratio(e0.start_derivative(), e0) + speed_ratio(e1.start_derivative(), e1));
  const double f_c1 = 0.5 * (speed_ratio(e0.end_derivative(), e0) + speed_ratio(e1.end_derivative(), e1));
  const double f_e0 = 0.5 * (speed_ratio(c0.start_derivative(), c0) + speed_ratio(c1.start_derivative(), c1));
  const double f_e1 = 0.5 * (speed_ratio(c0.end_derivative(), c0) + speed_ratio(c1.end_derivative(), c1));
  const auto field = [slide](const RibbonCurve& side, const Homogeneous& start, const Homogeneous& end,
                             const Vector3& middle) {
    return cross_field(side, cross_coefficients(side, start, end, middle, slide));
  };
  EnvelopePatch out{c0.curve, e1.curve, c1.curve, e0.curve, {}, {}, {}, {}};
  out.cross_c0 = field(c0, e0.start_rate(), e1.start_rate(), wanted(c0, along_v, f_c0));
  out.cross_c1 = field(c1, e0.end_rate(), e1.end_rate(), wanted(c1, along_v, f_c1));
  out.cross_e0 = field(e0, c0.start_rate(), c1.start_rate(), wanted(e0, along_u, f_e0));
  out.cross_e1 = field(e1, c0.end_rate(), c1.end_rate(), wanted(e1, along_u, f_e1));
  return out;
}

/// A part's patch with what its points share.
struct EnvelopePatchSet::Frame {
  const Part& part;
  const EnvelopePatch& patch;
  Corners corners;

  Rails across_u(const Direction& v) const {
    return rails(patch.e0, patch.cross_e0, patch.cross_e1, patch.e1, v);
  }
  Rails across_v(const Direction& u) const {
    return rails(patch.c0, patch.cross_c0, patch.cross_c1, patch.c1, u);
  }
  /// Of outer sides the curve alone decides, from both patches with the same bits.
  void set_side_position(double s, double t, PatchPoint& point) const {
    const auto set = [&](std::size_t side, double x) {
      if (!part.sides[side].outer) return false;
      const auto weight = bernstein_values<4>(x, 1 - x);
      const HomogeneousCubic& c = part.sides[side].curve;
      const Homogeneous at = (weight[0] * c[0] + weight[3] * c[3]) + (weight[1] * c[1] + weight[2] * c[2]);
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
  const Frame frame{part, patch, corners_of(patch)};
  const Direction u(part.part.u0 + part.part.size * parameter.x()),
      v(part.part.v0 + part.part.size * parameter.y());
  const HomogeneousPoint h =
      homogeneous_point(frame.corners, frame.across_u(v), frame.across_v(u), u, v, order);
  PatchPoint out = cartesian_point(h, part.part.size, order);
  frame.set_side_position(parameter.x(), parameter.y(), out);
  return out;
}

/// each(patch, parameter, point) for every point of the grid on every patch.
template <class Each>
void EnvelopePatchSet::for_grid(std::span<const Index> patches, const GridPattern& pattern, Order order,
                                const Each& each) const {
  HARIKO_ASSERT(pattern.domain == Domain::square, "patches of envelopes are squares");
  const int n = pattern.density;
  for (const Index index : patches) {
    const Part& part = parts_[index];
    const EnvelopePatch& patch = patches_[part.part.patch];
    const Frame frame{part, patch, corners_of(patch)};
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
        PatchPoint point = cartesian_point(
            homogeneous_point(frame.corners, across, along[k], us[k], v, order), part.part.size, order);
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
  const Vector2 middle(0.5, 0.5);
  std::size_t at = 0;
  for_grid(
      patches, pattern, Order::first, [&](Index patch, const Vector2& parameter, const PatchPoint& point) {
        positions[at] = point.position;
        normals[at] = unit_normal(point);
        if (normals[at].isZero(0))
          normals[at] = unit_normal(evaluate(patch, parameter + 1e-4 * (middle - parameter), Order::first));
        ++at;
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

namespace {

/// out += weight * point, in coordinates: the compiler does not look through a product of a vector here, and
/// half of a grid's time would go into its temporaries.
inline void add(Homogeneous& out, double weight, const Homogeneous& point) {
  for (Eigen::Index c = 0; c < 4; ++c) out.coeffRef(c) += weight * point.coeff(c);
}

template <std::size_t N>
Homogeneous combine(const std::array<Homogeneous, N>& control, const double* weight) {
  Homogeneous out = Homogeneous::Zero();
  for (std::size_t i = 0; i < N; ++i) add(out, weight[i], control[i]);
  return out;
}

using Lines = std::array<Homogeneous, 4>;

Lines lines_along(const EnvelopePatch& p, const double* cubic, const double* sextic) {
  return {combine(p.c0, cubic), combine(p.cross_c0, sextic), combine(p.cross_c1, sextic),
          combine(p.c1, cubic)};
}
/// Less the corners' part.
Lines lines_across(const EnvelopePatch& p, const Corners& m, const double* cubic, const double* sextic,
                   const double* hermite) {
  Lines out{combine(p.e0, cubic), combine(p.cross_e0, sextic), combine(p.cross_e1, sextic),
            combine(p.e1, cubic)};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t l = 0; l < 4; ++l) add(out[k], -hermite[l], m.constant[k][l]);
  return out;
}

/// The lines through a node, and the derivatives along them.
struct NodeLines {
  Lines value, rate;
};

struct NodeTangents {
  Homogeneous u, v;
};

/// `p`, `q`: distances of the node from the sides u = 0 and v = 0.
NodeTangents tangents_at(const Corners& m, const GridBasis& u, const GridBasis& v, const NodeLines& along,
                         const NodeLines& across, double p, double q) {
  NodeTangents out{Homogeneous::Zero(), Homogeneous::Zero()};
  for (std::size_t k = 0; k < 4; ++k) {
    add(out.u, u.hermite_rate[k], across.value[k]);
    add(out.u, v.hermite[k], along.rate[k]);
    add(out.v, u.hermite[k], across.rate[k]);
    add(out.v, v.hermite_rate[k], along.value[k]);
  }
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = 0; b < 2; ++b) {
      const Ratio x = ratio(a == 0 ? p : 1 - p, b == 0 ? q : 1 - q);
      const double fu = u.hermite[1 + a], fv = v.hermite[1 + b];
      add(out.u, -fv * (u.hermite_rate[1 + a] * x.value + (a == 0 ? fu : -fu) * x.p), m.share[a][b]);
      add(out.v, -fu * (v.hermite_rate[1 + b] * x.value + (b == 0 ? fv : -fv) * x.q), m.share[a][b]);
    }
  return out;
}

Vector3 unit_normal_of(const Vector3& position, const NodeTangents& tangents) {
  const Vector3 su = tangents.u.head<3>() - position * tangents.u.w(),
                sv = tangents.v.head<3>() - position * tangents.v.w();
  const Vector3 cross = su.cross(sv);
  const double length = cross.norm();
  if (!(length > 1e-12 * su.norm() * sv.norm() && length > 0)) return Vector3::Zero();
  return cross / length;
}

}  // namespace

EnvelopeGrid::EnvelopeGrid(int intervals) : intervals_(intervals) {
  for (int i = 0; i <= intervals; ++i) {
    const Direction at(grid_fraction(i, intervals));
    GridBasis basis;
    std::copy_n(at.cubic.value.data(), 4, basis.cubic);
    std::copy_n(at.cubic.first.data(), 4, basis.cubic_rate);
    std::copy_n(at.sextic.value.data(), 7, basis.sextic);
    std::copy_n(at.sextic.first.data(), 7, basis.sextic_rate);
    std::copy_n(at.hermite.value.data(), 4, basis.hermite);
    std::copy_n(at.hermite.first.data(), 4, basis.hermite_rate);
    basis_.push_back(basis);
  }
  for (int j = 0; j <= intervals; ++j)
    for (int i = 0; i <= intervals; ++i) {
      std::array<double, 4> weights;
      for (std::size_t corner = 0; corner < 4; ++corner) {
        const std::size_t a = corner / 2, b = corner % 2;
        const double p = double(a == 0 ? i : intervals - i), q = double(b == 0 ? j : intervals - j);
        weights[corner] =
            basis_[std::size_t(i)].hermite[1 + a] * basis_[std::size_t(j)].hermite[1 + b] * ratio(p, q).value;
      }
      twists_.push_back(weights);
    }
}

void EnvelopeGrid::evaluate(const EnvelopePatch& patch, std::span<Vector3> positions) const {
  const Corners m = corners_of(patch);
  std::vector<Lines> along;
  for (const GridBasis& b : basis_) along.push_back(lines_along(patch, b.cubic, b.sextic));
  std::size_t at = 0;
  for (const GridBasis& v : basis_) {
    const Lines across = lines_across(patch, m, v.cubic, v.sextic, v.hermite);
    for (std::size_t i = 0; i < basis_.size(); ++i, ++at) {
      const GridBasis& u = basis_[i];
      Homogeneous value = Homogeneous::Zero();
      for (std::size_t k = 0; k < 4; ++k) {
        add(value, u.hermite[k], across[k]);
        add(value, v.hermite[k], along[i][k]);
      }
      for (std::size_t corner = 0; corner < 4; ++corner)
        add(value, -twists_[at][corner], m.share[corner / 2][corner % 2]);
      positions[at] = value.head<3>() * (1 / value.w());
    }
  }
}

void EnvelopeGrid::evaluate(const EnvelopePatch& patch, std::span<Vector3> positions,
                            std::span<Vector3> normals) const {
  evaluate(patch, positions);
  const Corners m = corners_of(patch);
  std::vector<NodeLines> along;
  for (const GridBasis& b : basis_)
    along.push_back({lines_along(patch, b.cubic, b.sextic), lines_along(patch, b.cubic_rate, b.sextic_rate)});
  std::size_t at = 0;
  for (std::size_t j = 0; j < basis_.size(); ++j) {
    const GridBasis& v = basis_[j];
    const NodeLines across{lines_across(patch, m, v.cubic, v.sextic, v.hermite),
                           lines_across(patch, m, v.cubic_rate, v.sextic_rate, v.hermite_rate)};
    for (std::size_t i = 0; i < basis_.size(); ++i, ++at)
      normals[at] = unit_normal_of(
          positions[at],
          tangents_at(m, basis_[i], v, along[i], across, double(i) / intervals_, double(j) / intervals_));
  }
}

Vector3 EnvelopeGrid::normal(const EnvelopePatch& patch, std::size_t i, std::size_t j) const {
  const Corners m = corners_of(patch);
  const GridBasis &u = basis_[i], &v = basis_[j];
  const NodeLines along{lines_along(patch, u.cubic, u.sextic),
                        lines_along(patch, u.cubic_rate, u.sextic_rate)};
  const NodeLines across{lines_across(patch, m, v.cubic, v.sextic, v.hermite),
                         lines_across(patch, m, v.cubic_rate, v.sextic_rate, v.hermite_rate)};
  Homogeneous value = Homogeneous::Zero();
  for (std::size_t k = 0; k < 4; ++k) {
    add(value, u.hermite[k], across.value[k]);
    add(value, v.hermite[k], along.value[k]);
  }
  const auto& twist = twists_[j * basis_.size() + i];
  for (std::size_t corner = 0; corner < 4; ++corner)
    add(value, -twist[corner], m.share[corner / 2][corner % 2]);
  return unit_normal_of(cartesian(value),
                        tangents_at(m, u, v, along, across, double(i) / intervals_, double(j) / intervals_));
}

}  // namespace hariko

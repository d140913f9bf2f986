#include "core/g2/faces/face_chart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/assert.hpp"
#include "core/g2/faces/chart_polygon.hpp"
#include "core/g2/faces/ribbon_functions.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
/// Distance from a vertex, in sides, below which its quadratic replaces the blend: the blend differs from it
/// by the third order, and its second derivatives lose digits to the division by the square of the distance.
constexpr double vertex_radius = 1e-6;
/// Threshold of weights: a ribbon whose weight is below the cube of this is not evaluated.
constexpr double cut_off = 1e-13;
/// Least reach of a ribbon, in apothems, for sides far shorter than those beside them.
constexpr double least_reach = 0.03;
/// Reach of a ribbon, in apothems, per slenderness: in a quad, it is as long as the side.
constexpr double longest_reach = 2;
/// Largest unit of distance from a side in the weights, in sides of the regular polygon.
constexpr double longest_unit = 2.5;
/// Sine of a straight corner of a polygon, at most.
constexpr double straight_sine = 1e-9;

/// Radians: a corner's map is linear below.
constexpr double least_rotation = 1e-9;

/// Radius within which a chart is opened at a corner, in the shorter edge of the corner.
constexpr double opened_reach = 1;

/// Number of sides of a regular polygon whose corners' turn, halved, is the largest that opens distances.
constexpr int most_turning = 6;

int centre_degree(int n) {
  return n <= 6 ? 4 : std::max(4, std::min(8, (n + 1) / 2));
}

}  // namespace

bool is_straight(double angle) {
  return angle > pi - 1e-9;
}

bool lies_straight(const Vector2& previous, const Vector2& corner, const Vector2& next) {
  const Vector2 forward = next - corner, back = previous - corner;
  return forward.dot(back) < 0 && cross(forward, back) < straight_sine * forward.norm() * back.norm();
}

FaceChart::FaceChart(std::vector<CornerShape> corners, std::vector<Vector2> polygon,
                     const std::vector<int>& joined)
    : corners_(std::move(corners)), vertices_(std::move(polygon)) {
  const int n = sides();
  HARIKO_ASSERT(n >= 3, "a face has three sides or more");
  HARIKO_ASSERT(vertices_.size() == corners_.size(), "one vertex a corner");
  degree_ = centre_degree(n);
  departure_.assign(static_cast<std::size_t>(n), -1);
  for (const int side : joined) {
    departure_[std::size_t(side)] = first_departure_control() + departure_count_;
    departure_count_ += side_departure_count;
  }
  set_corners();
  set_sides();
  set_active();
}

void FaceChart::set_corners() {
  const int n = sides();
  for (int j = 0; j < n; ++j) {
    const CornerShape& at = corner(j);
    HARIKO_ASSERT(at.angle > 0 && at.angle < pi + 1e-9, "a corner spans at most a half turn");
    HARIKO_ASSERT(at.out > 0 && at.in > 0 && at.across_out > 0 && at.across_in > 0, "lengths are positive");
    straight_.push_back(is_straight(at.angle));
    cosine_.push_back(straight_.back() ? -1.0 : std::cos(at.angle));
    sine_.push_back(straight_.back() ? 0.0 : std::sin(at.angle));
    const Vector2 forward = vertex((j + 1) % n) - vertex(j), back = vertex((j + n - 1) % n) - vertex(j);
    const double f = forward.norm(), b = back.norm();
    const Vector2 e = forward / f, d = back / b;
    const double own_cosine = e.dot(d), own_sine = e.x() * d.y() - e.y() * d.x();
    const bool flat =
        straight_.back() && lies_straight(vertex((j + n - 1) % n), vertex(j), vertex((j + 1) % n));
    singular_.push_back(straight_.back() && !flat);
    CornerSide out, in;
    out.along = e / f, out.across = in.other = {-e.y(), e.x()};
    in.along = d / b, in.across = out.other = {d.y(), -d.x()};
    if (flat) {
      out.rise = at.out / f / at.across_out;
      in.rise = at.in / b / at.across_in;
    } else if (!straight_.back()) {
      const double angle = linear_angle(at, vertex(j), vertex((j + 1) % n), vertex((j + n - 1) % n));
      const double c = std::cos(angle), s = std::sin(angle);
      out.slant = (at.in / at.out * c / b - own_cosine / f) / own_sine;
      in.slant = (at.out / at.in * c / f - own_cosine / b) / own_sine;
      out.rise = at.in * s / (b * own_sine) / at.across_out;
      in.rise = at.out * s / (f * own_sine) / at.across_in;
      out.length = at.out, out.unit = at.across_out, in.length = at.in, in.unit = at.across_in;
      out.turn = in.turn = std::abs(at.angle - angle) > least_rotation ? at.angle / angle - 1 : 0;
    }
    opens_ = opens_ || out.turn != 0;
    if (!singular_.back()) bend_toward_centre(j, out, in);
    out_.push_back(out);
    in_.push_back(in);
    // Sides of a corner that turns less than half as much as in the regular polygon of up to six sides.
    const double turn = std::atan2(own_sine, -own_cosine),
                 u = std::clamp(1 - turn * std::min(n, most_turning) / pi, 0.0, 1.0);
    opening_.push_back(u * u * (3 - 2 * u));
  }
}

/// Terms of second order that draw the image of the face's centre, where a corner's linear map goes beyond
/// the corner's own parallelogram, to its distance in the vertex's chart: the share by which it goes beyond.
void FaceChart::bend_toward_centre(int j, CornerSide& out, CornerSide& in) const {
  const CornerShape& at = corner(j);
  if (at.centre_distance == 0) return;
  const Vector2 from = -vertex(j);
  const Vector2 forward = vertex((j + 1) % sides()) - vertex(j);
  const Vector2 back = vertex((j + sides() - 1) % sides()) - vertex(j);
  const double from_out = out.across.dot(from), from_in = in.across.dot(from);
  const double reached = from_in / in.across.dot(forward) + from_out / out.across.dot(back);
  const double beyond = std::max(0.0, 1 - 1 / reached);
  const double y1 = at.out * (out.along.dot(from) + out.slant * from_out);
  const double y2 = at.across_out * out.rise * from_out;
  const double gain = beyond * (at.centre_distance / std::hypot(y1, y2) - 1) / (from_out * from_in);
  for (CornerSide* side : {&out, &in}) {
    const double across = side->across.dot(from);
    side->bend_along = gain * (side->along.dot(from) + side->slant * across);
    side->bend_across = gain * side->rise * across;
  }
}

void FaceChart::set_sides() {
  const int n = sides();
  double length = 0;
  for (int k = 0; k < n; ++k) {
    const Vector2 side = vertex((k + 1) % n) - vertex(k);
    normals_.push_back(Vector2(-side.y(), side.x()).normalized());
    apothems_.push_back(-normals_.back().dot(vertex(k)));
    HARIKO_ASSERT(apothems_.back() > 0, "the centre lies within the polygon");
    radius_ = std::max(radius_, vertex(k).norm());
    area_ += 0.5 * apothems_.back() * side.norm();
    length += side.norm();
  }
  apothem_ = 2 * area_ / length;
  for (int k = 0; k < n; ++k) {
    const double shape = std::min(longest_reach * slenderness(k), side_length(k) / apothems_[std::size_t(k)]);
    reach_.push_back(std::min(full_reach(k), std::max(least_reach, shape)));
    // By measure: in polygons of many sides ribbons would give way to the centre all at once near their ends.
    unit_.push_back(corner(k).centre_distance == 0 ? 1
                                                   : std::min(1.0, longest_unit / apothems_[std::size_t(k)]));
  }
}

void FaceChart::set_active() {
  const int n = sides();
  for (int k = 0; k < n; ++k) {
    std::vector<int> near;
    for (int m = 0; m < n; ++m) {
      const auto distance = [&](int corner) {
        return 1 + normals_[std::size_t(m)].dot(vertex(corner)) / apothems_[std::size_t(m)];
      };
      if (std::min(distance(k), distance((k + 1) % n)) < reach(m) - cut_off) near.push_back(m);
    }
    std::vector<bool> corner(static_cast<std::size_t>(n), false);
    for (const int m : near) corner[std::size_t(m)] = corner[std::size_t((m + 1) % n)] = true;
    std::vector<int> active;
    for (int c = 0; c < n; ++c)
      for (int i = 0; corner[std::size_t(c)] && i < corner_control_count; ++i)
        active.push_back(corner_control_count * c + i);
    for (const int m : near)
      for (int i = 0; i < side_control_count; ++i) active.push_back(side_control(m, SideControl(i)));
    for (int i = first_centre_control(); i < first_departure_control(); ++i) active.push_back(i);
    for (const int m : near)
      for (int i = 0; joined(m) && i < side_departure_count; ++i)
        active.push_back(departure_control(m, SideDeparture(i)));
    near_sides_.push_back(std::move(near));
    active_.push_back(std::move(active));
  }
}

template <class Jet>
FaceChart::CornerPoint<Jet> FaceChart::in_corner(int corner, const Vector2& point) const {
  const int n = sides();
  const Vector2 &v = vertex(corner), forward = vertex((corner + 1) % n) - v,
                back = vertex((corner + n - 1) % n) - v;
  const auto along = [&](const Vector2& axis, const Vector2& other) {
    const double determinant = axis.x() * other.y() - axis.y() * other.x();
    const double ax = other.y() / determinant, ay = -other.x() / determinant;
    return Jet::linear(ax * (point.x() - v.x()) + ay * (point.y() - v.y()), ax, ay);
  };
  return {along(forward, back), along(back, forward)};
}

/// Length of a side relative to the width across it, the extent of the sides beside it; the smaller ratio of
/// both ends.
double FaceChart::slenderness(int side) const {
  const int b = (side + 1) % sides();
  const CornerShape &at = corner(side), &to = corner(b);
  const double first = straight(side) ? 1 : at.out / (at.in * sine(side));
  return std::min(first, straight(b) ? 1 : to.in / (to.out * sine(b)));
}

double FaceChart::full_reach(int side) const {
  return std::min(1.0, 0.9 / apothems_[std::size_t(side)]);
}

bool FaceChart::ends_early(int side) const {
  return reach(side) < 0.8 * full_reach(side);
}

double FaceChart::end_along(int side, int end) const {
  const int n = sides(), corner = (side + end) % n, beside = end == 0 ? (side + n - 1) % n : corner;
  const Vector2 along = vertex((side + 1 - end) % n) - vertex(corner);
  const double length = along.norm();
  // Distance from the side beside it, a length along this one.
  const Vector2 back = (vertex(end == 0 ? beside : (corner + 1) % n) - vertex(corner)).normalized();
  const double cosine = along.dot(back) / length,
               sine = std::abs(normals_[std::size_t(beside)].dot(along)) / length;
  const double open = opening_[std::size_t(corner)] / 2;
  const double rise = std::sqrt(sine * sine + open * (1 - cosine) * (1 - cosine));
  return reach(beside) * apothems_[std::size_t(beside)] / (rise * length);
}

std::array<Jet3, 2> FaceChart::opened(const Vector2& point) const {
  std::array<Jet3, 2> out{Jet3::linear(point.x(), 1, 0), Jet3::linear(point.y(), 0, 1)};
  for (int j = 0; j < sides(); ++j)
    if (out_[std::size_t(j)].turn != 0) add_opening(j, point, out);
  return out;
}

/// Opens the chart at a corner.
void FaceChart::add_opening(int j, const Vector2& point, std::array<Jet3, 2>& out) const {
  const CornerSide& side = out_[std::size_t(j)];
  const CornerShape& at = corner(j);
  const Vector2 &v = vertex(j), forward = vertex((j + 1) % sides()) - v,
                back = vertex((j + sides() - 1) % sides()) - v;
  const double angle = at.angle / (1 + side.turn);
  const auto [x, y] = side.opening(point - v, angle, opened_reach * std::min(at.out, at.in));
  // From the vertex's chart back to this one: forward is (out, 0) there, back is `in` at the angle.
  const Jet3 by_back = (1 / (at.in * std::sin(angle))) * y,
             by_forward = (1 / at.out) * (x - (at.in * std::cos(angle)) * by_back);
  out[0] += forward.x() * by_forward + back.x() * by_back;
  out[1] += forward.y() * by_forward + back.y() * by_back;
}

template <class Jet>
CornerMap<Jet> FaceChart::outgoing(int j, const Vector2& point) const {
  if (!singular(j)) return out_[std::size_t(j)].operator()<Jet>(point - vertex(j));
  const auto [alpha, beta] = in_corner<Jet>(j, point);
  return {alpha - beta,
          (2 * corner(j).out / corner(j).across_out) * (alpha * beta * reciprocal(alpha + beta))};
}

template <class Jet>
CornerMap<Jet> FaceChart::incoming(int j, const Vector2& point) const {
  const Jet one = Jet::constant(1);
  if (!singular(j)) {
    const auto [t, s] = in_[std::size_t(j)].operator()<Jet>(point - vertex(j));
    return {one - t, s};
  }
  const auto [alpha, beta] = in_corner<Jet>(j, point);
  return {one - (beta - alpha),
          (2 * corner(j).in / corner(j).across_in) * (alpha * beta * reciprocal(alpha + beta))};
}

template <class Jet>
void FaceChart::vertex_jet(int j, const Vector2& point, std::vector<Jet>& all) const {
  const CornerShape& at = corner(j);
  Jet y1, y2;
  if (singular(j)) {
    // The map is not differentiable at the corner: its derivative along the diagonal replaces it, which
    // leaves the tangent plane and the curvature unchanged.
    const auto [alpha, beta] = in_corner<Jet>(j, point);
    y1 = at.out * (alpha - beta);
    y2 = (0.5 * at.out) * (alpha + beta);
  } else {
    // Any linear map of the corner leaves the tangent plane and the curvature unchanged.
    const auto [t, s] = out_[std::size_t(j)].unturned<Jet>(point - vertex(j), false);
    y1 = at.out * t;
    y2 = at.across_out * s;
  }
  const auto set = [&](CornerControl which, const Jet& jet) {
    all[std::size_t(corner_control(j, which))] = jet;
  };
  set(corner_p, Jet::constant(1));
  set(corner_g1, y1);
  set(corner_g2, y2);
  set(corner_g11, 0.5 * (y1 * y1));
  set(corner_g12, y1 * y2);
  set(corner_g22, 0.5 * (y2 * y2));
}

/// Distance from a side, in its apothem. Beside corners that hardly turn it grows along the line of the side,
/// too, so that it vanishes on the side alone.
template <class Jet>
Jet FaceChart::distance(int side, const Vector2& point) const {
  const int b = (side + 1) % sides();
  const double apothem = apothems_[std::size_t(side)];
  const Vector2 slope = normals_[std::size_t(side)] / apothem;
  const Jet line = Jet::linear(1 + slope.dot(point), slope.x(), slope.y());
  if (opening_[std::size_t(side)] == 0 && opening_[std::size_t(b)] == 0) return line;
  const Jet across = apothem * line;
  Jet factor = Jet::constant(1), beyond = Jet::constant(0);
  bool within = true;
  for (const int end : {side, b}) {
    const double open = 0.5 * opening_[std::size_t(end)];
    if (open == 0) continue;
    const Vector2 along = (vertex(end == side ? b : side) - vertex(end)).normalized();
    const Jet x = Jet::linear(along.dot(point - vertex(end)), along.x(), along.y());
    const Jet r = square_root(x * x + across * across);
    if (x.v > 0) {
      const Jet q = across * reciprocal(r + x);
      factor += open * (q * q);
    } else {
      const Jet z = r - x;
      beyond += (open / (apothem * apothem)) * (z * z);
      within = false;
    }
  }
  return within ? line * square_root(factor) : square_root(line * line * factor + beyond);
}

template <class Jet>
void FaceChart::add_ribbon(int side, const Vector2& point, const Jet& weight, Room<Jet>& room) const {
  const int n = sides(), a = side, b = (side + 1) % n;
  const CornerMap<Jet> out = outgoing<Jet>(a, point), in = incoming<Jet>(b, point);
  const Jet &before = room.distance[std::size_t((side + n - 1) % n)], &after = room.distance[std::size_t(b)];
  const Jet tau = before * reciprocal(before + after);
  const Jet blend = compose(
      Derivatives{(3 - 2 * tau.v) * tau.v * tau.v, 6 * tau.v * (1 - tau.v), 6 - 12 * tau.v, -12}, tau);
  const Jet t = out.t + blend * (in.t - out.t);
  const Jet s = out.s + blend * (in.s - out.s);

  Derivatives r0[7], r1[6], r2[4];
  ribbon_quintic(t.v, r0);
  ribbon_cubic(t.v, r1);
  ribbon_linear(t.v, r2);
  const Jet once = weight * s, twice = 0.5 * (once * s);
  Jet f0[7], f1[6], f2[4];
  for (int i = 0; i < 7; ++i) f0[i] = weight * compose(r0[i], t);
  for (int i = 0; i < 6; ++i) f1[i] = once * compose(r1[i], t);
  for (int i = 0; i < 4; ++i) f2[i] = twice * compose(r2[i], t);

  std::vector<Jet>& all = room.all;
  const auto at = [&](int corner, CornerControl which) -> Jet& {
    return all[std::size_t(corner_control(corner, which))];
  };
  const double la = corner(a).out, sa = corner(a).across_out, lb = corner(b).in, sb = corner(b).across_in;
  at(a, corner_p) += f0[0];
  at(a, corner_g1) += la * f0[1];
  at(a, corner_g11) += (la * la) * f0[2];
  at(a, corner_g2) += sa * f1[0];
  at(a, corner_g12) += (sa * la) * f1[1];
  at(a, corner_g22) += (sa * sa) * f2[0];
  // Derivatives at b in the frame of the edge that closes the corner, seen from b.
  const double c = cosine(b), d = sine(b);
  const Jet g1 = -lb * f0[4], g11 = (lb * lb) * f0[5], g2 = -sb * f1[2], g12 = (sb * lb) * f1[3],
            g22 = (sb * sb) * f2[1];
  at(b, corner_p) += f0[3];
  at(b, corner_g1) += c * g1 - d * g2;
  at(b, corner_g2) += d * g1 + c * g2;
  at(b, corner_g11) += (c * c) * g11 - (c * d) * g12 + (d * d) * g22;
  at(b, corner_g12) += (2 * c * d) * g11 + (c * c - d * d) * g12 - (2 * c * d) * g22;
  at(b, corner_g22) += (d * d) * g11 + (c * d) * g12 + (c * c) * g22;
  const auto own = [&](SideControl which) -> Jet& { return all[std::size_t(side_control(side, which))]; };
  own(side_e0) = f0[6];
  own(side_e1) = f1[4];
  own(side_e1_odd) = f1[5];
  own(side_e2) = f2[2];
  own(side_e2_odd) = f2[3];
  if (!joined(side)) return;
  const auto departs = [&](SideDeparture which) -> Jet& {
    return all[std::size_t(departure_control(side, which))];
  };
  departs(departs_curve_a) = f0[2];
  departs(departs_cross_a) = f1[1];
  departs(departs_curve_b) = f0[5];
  departs(departs_cross_b) = f1[3];
}

template <class Jet>
void FaceChart::add_centre(const Vector2& point, const Jet& weight, std::vector<Jet>& all) const {
  const double unit = 1 / radius_;
  const Jet x = Jet::linear(point.x() * unit, unit, 0), y = Jet::linear(point.y() * unit, 0, unit);
  auto k = static_cast<std::size_t>(first_centre_control());
  all[k] = weight;
  std::size_t row = k;  // x^degree y^0 comes first in each degree
  for (int degree = 1; degree <= degree_; ++degree) {
    const std::size_t next = row + static_cast<std::size_t>(degree);
    for (int i = 0; i < degree; ++i) all[next + std::size_t(i)] = x * all[row + std::size_t(i)];
    all[next + std::size_t(degree)] = y * all[row + std::size_t(degree) - 1];
    row = next;
  }
}

template <class Jet>
void FaceChart::basis(int side, const Vector2& point, std::span<Jet> out, Room<Jet>& room) const {
  const int n = sides();
  const std::vector<int>& active = active_[std::size_t(side)];
  std::vector<Jet>& all = room.all;
  all.resize(std::size_t(control_count()));
  for (const int k : active) all[std::size_t(k)] = Jet{};
  const auto copy = [&] {
    for (std::size_t i = 0; i < active.size(); ++i) out[i] = all[std::size_t(active[i])];
  };
  for (const int corner : {side, (side + 1) % n})
    if ((point - vertex(corner)).squaredNorm() < vertex_radius * vertex_radius) {
      vertex_jet(corner, point, all);
      return copy();
    }

  std::vector<Jet>& distance = room.distance;
  distance.resize(std::size_t(n));
  const std::vector<int>& near = near_sides_[std::size_t(side)];
  constexpr int most_reached = 24;
  int reached[most_reached];
  int count = 0;
  for (const int m : near) {
    for (const int k : {(m + n - 1) % n, m, (m + 1) % n})
      distance[std::size_t(k)] = this->distance<Jet>(k, point);
    if (!(distance[std::size_t(m)].v < reach(m) - cut_off)) continue;
    HARIKO_ASSERT(count < most_reached, "few ribbons reach a point");
    reached[count++] = m;
  }
  // Weights w_m ~ (1 - d_m / reach)^3 prod_(k != m) (d_k / unit)^3, and prod_k (d_k / unit)^3 for the centre;
  // factors of sides out of reach cancel.
  Jet weight[most_reached], cubed[most_reached], centre = Jet::constant(1), sum = Jet::constant(0);
  for (int i = 0; i < count; ++i) {
    const Jet& own = distance[std::size_t(reached[i])];
    weight[i] = cube(Jet::constant(1) - (1 / reach(reached[i])) * own);
    cubed[i] = cube((1 / unit_[std::size_t(reached[i])]) * own);
    centre = centre * cubed[i];
  }
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < count; ++k)
      if (k != i) weight[i] = weight[i] * cubed[k];
    sum += weight[i];
  }
  sum += centre;
  const Jet share = reciprocal(sum);
  for (int i = 0; i < count; ++i) add_ribbon(reached[i], point, weight[i] * share, room);
  add_centre(point, centre * share, all);
  copy();
}
template void FaceChart::basis(int, const Vector2&, std::span<Jet2>, Room<Jet2>&) const;
template void FaceChart::basis(int, const Vector2&, std::span<Jet3>, Room<Jet3>&) const;

FaceChart::Curve FaceChart::curve(double t) {
  Derivatives r0[7];
  ribbon_quintic(t, r0);
  Curve out;
  for (int i = 0; i < 7; ++i) {
    const double sign = i == 4 ? -1 : 1;  // g1 at b points back along the edge
    out.value[i] = sign * r0[i].v;
    out.first[i] = sign * r0[i].d;
    out.second[i] = sign * r0[i].dd;
  }
  return out;
}

std::array<int, FaceChart::curve_control_count> FaceChart::curve_controls(int side) const {
  const int a = side, b = (side + 1) % sides();
  return {corner_control(a, corner_p),   corner_control(a, corner_g1),  corner_control(a, corner_g11),
          corner_control(b, corner_p),   corner_control(b, corner_g1),  corner_control(b, corner_g2),
          corner_control(b, corner_g11), corner_control(b, corner_g12), corner_control(b, corner_g22),
          side_control(side, side_e0)};
}

std::array<double, FaceChart::curve_control_count> FaceChart::spread_curve(int side,
                                                                           const double (&seven)[7]) const {
  const int b = (side + 1) % sides();
  const double c = cosine(b), d = sine(b), la = corner(side).out, lb = corner(b).in, square = lb * lb;
  return {seven[0],
          la * seven[1],
          la * la * seven[2],
          seven[3],
          lb * c * seven[4],
          lb * d * seven[4],
          square * c * c * seven[5],
          square * 2 * c * d * seven[5],
          square * d * d * seven[5],
          seven[6]};
}

}  // namespace hariko

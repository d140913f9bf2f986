#include "core/g2/face_chart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr double pi = std::numbers::pi;
/// Distance from a vertex, in sides, below which its quadratic stands for the blend: the blend differs from
/// it by the third order, and its second derivatives lose digits to the division by the square of the
/// distance.
constexpr double vertex_radius = 1e-6;
/// A ribbon whose weight is below the cube of this is not evaluated.
constexpr double cut_off = 1e-13;

int centre_degree(int n) {
  return n <= 6 ? 4 : std::max(4, std::min(8, (n + 1) / 2));
}

double sigma(double sine, bool straight) {
  return straight ? 1.0 : sine;
}

/// Value, first and second derivative of a function of t.
struct Along {
  double v, d, dd;
};

/// Quintic Hermite functions for (value, first, second) at 0, then at 1, and t^3 (1 - t)^3.
void quintic(double t, Along (&out)[7]) {
  const double a = 1 - t, t2 = t * t, t3 = t2 * t, a2 = a * a, a3 = a2 * a;
  out[0] = {a3 * (1 + 3 * t + 6 * t2), -30 * t2 * a2, -60 * t * a * (1 - 2 * t)};
  out[1] = {t * a3 * (1 + 3 * t), a2 * (1 - 3 * t) * (1 + 5 * t), t * a * (-36 + 60 * t)};
  out[2] = {0.5 * t2 * a3, 0.5 * t * a2 * (2 - 5 * t), 0.5 * a * (2 - 16 * t + 20 * t2)};
  out[3] = {t3 * (1 + 3 * a + 6 * a2), 30 * t2 * a2, 60 * t * a * (1 - 2 * t)};
  // Derivative at 1 along increasing t.
  out[4] = {-a * t3 * (1 + 3 * a), t2 * (1 - 3 * a) * (1 + 5 * a), -a * t * (-36 + 60 * a)};
  out[5] = {0.5 * a2 * t3, -0.5 * a * t2 * (2 - 5 * a), 0.5 * t * (2 - 16 * a + 20 * a2)};
  out[6] = {t3 * a3, 3 * t2 * a2 * (1 - 2 * t), 6 * t * a * (1 - 5 * t * a)};
}

/// Cubic Hermite functions, t^2 (1 - t)^2, and that times 2t - 1.
void cubic(double t, Along (&out)[6]) {
  const double a = 1 - t, t2 = t * t, a2 = a * a;
  out[0] = {a2 * (1 + 2 * t), -6 * t * a, -6 + 12 * t};
  out[1] = {t * a2, a * (1 - 3 * t), -4 + 6 * t};
  out[2] = {t2 * (1 + 2 * a), 6 * t * a, 6 - 12 * t};
  out[3] = {-a * t2, t * (1 - 3 * a), 4 - 6 * a};
  const double bump = t2 * a2, bump1 = 2 * t * a * (1 - 2 * t), bump2 = 2 - 12 * t * a;
  out[4] = {bump, bump1, bump2};
  out[5] = {bump * (2 * t - 1), bump1 * (2 * t - 1) + 2 * bump, bump2 * (2 * t - 1) + 4 * bump1};
}

/// Linear functions, t (1 - t), and that times 2t - 1.
void linear(double t, Along (&out)[4]) {
  out[0] = {1 - t, -1, 0};
  out[1] = {t, 1, 0};
  const double bump = t * (1 - t), bump1 = 1 - 2 * t;
  out[2] = {bump, bump1, -2};
  out[3] = {bump * (2 * t - 1), bump1 * (2 * t - 1) + 2 * bump, -2 * (2 * t - 1) + 4 * bump1};
}

}  // namespace

bool is_straight(double angle) {
  return angle > pi - 1e-9;
}

FaceChart::FaceChart(std::vector<double> angles, const std::vector<int>& joined)
    : angles_(std::move(angles)) {
  const int n = sides();
  HARIKO_ASSERT(n >= 3, "a face has three sides or more");
  radius_ = 1 / (2 * std::sin(pi / n));
  apothem_ = 1 / (2 * std::tan(pi / n));
  reach_ = n == 3 ? 1.0 : std::min(1.0, 0.9 / apothem_);
  degree_ = centre_degree(n);
  departure_.assign(static_cast<std::size_t>(n), -1);
  for (const int side : joined) {
    departure_[std::size_t(side)] = first_departure_control() + departure_count_;
    departure_count_ += side_departure_count;
  }
  for (int j = 0; j < n; ++j) {
    const double turn = 2 * pi * j / n, middle = 2 * pi * (j + 0.5) / n;
    vertices_.emplace_back(radius_ * std::cos(turn), radius_ * std::sin(turn));
    normals_.emplace_back(-std::cos(middle), -std::sin(middle));
    const double angle = angles_[static_cast<std::size_t>(j)];
    HARIKO_ASSERT(angle > 0 && angle < pi + 1e-9, "a corner spans at most a half turn");
    straight_.push_back(is_straight(angle));
    cosine_.push_back(straight_.back() ? -1.0 : std::cos(angle));
    sine_.push_back(straight_.back() ? 0.0 : std::sin(angle));
  }
  for (int k = 0; k < n; ++k) {
    std::vector<int> near;
    for (int m = 0; m < n; ++m) {
      const auto distance = [&](int corner) {
        return 1 + normals_[std::size_t(m)].dot(vertex(corner)) / apothem_;
      };
      if (std::min(distance(k), distance((k + 1) % n)) < reach_ - cut_off) near.push_back(m);
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
      for (int i = 0; this->joined(m) && i < side_departure_count; ++i)
        active.push_back(departure_control(m, SideDeparture(i)));
    near_sides_.push_back(std::move(near));
    active_.push_back(std::move(active));
  }
}

double FaceChart::area() const {
  return 0.5 * sides() * apothem_;
}

/// Coordinate along `along` of point - at = coordinate along + second other.
Jet2 FaceChart::line(const Vector2& point, const Vector2& at, const Vector2& along,
                     const Vector2& other) const {
  const double determinant = along.x() * other.y() - along.y() * other.x();
  const double ax = other.y() / determinant, ay = -other.x() / determinant;
  return Jet2::linear(ax * (point.x() - at.x()) + ay * (point.y() - at.y()), ax, ay);
}

FaceChart::CornerMap FaceChart::outgoing(int corner, const Vector2& point) const {
  const int n = sides();
  const Vector2 &v = vertex(corner), forward = vertex((corner + 1) % n) - v,
                back = vertex((corner + n - 1) % n) - v;
  const Jet2 alpha = line(point, v, forward, back), beta = line(point, v, back, forward);
  if (!straight(corner)) return {alpha + cosine_[std::size_t(corner)] * beta, beta};
  return {alpha - beta, 2 * (alpha * beta * reciprocal(alpha + beta))};
}

FaceChart::CornerMap FaceChart::incoming(int corner, const Vector2& point) const {
  const int n = sides();
  const Vector2 &v = vertex(corner), forward = vertex((corner + 1) % n) - v,
                back = vertex((corner + n - 1) % n) - v;
  const Jet2 alpha = line(point, v, forward, back), beta = line(point, v, back, forward),
             one = Jet2::constant(1);
  if (!straight(corner)) return {one - (beta + cosine_[std::size_t(corner)] * alpha), alpha};
  return {one - (beta - alpha), 2 * (alpha * beta * reciprocal(alpha + beta))};
}

void FaceChart::vertex_jet(int corner, const Vector2& point, std::vector<Jet2>& all) const {
  const int n = sides();
  const Vector2 &v = vertex(corner), forward = vertex((corner + 1) % n) - v,
                back = vertex((corner + n - 1) % n) - v;
  const Jet2 alpha = line(point, v, forward, back), beta = line(point, v, back, forward);
  const auto c = static_cast<std::size_t>(corner);
  // A straight corner's map is not differentiable at the corner: its derivative along the diagonal stands for
  // it, which leaves the tangent plane and the curvature as they are.
  const Jet2 y1 = straight(corner) ? alpha - beta : alpha + cosine_[c] * beta;
  const Jet2 y2 = straight(corner) ? 0.5 * (alpha + beta) : sine_[c] * beta;
  const auto set = [&](CornerControl which, const Jet2& jet) {
    all[std::size_t(corner_control(corner, which))] = jet;
  };
  set(corner_p, Jet2::constant(1));
  set(corner_g1, y1);
  set(corner_g2, y2);
  set(corner_g11, 0.5 * (y1 * y1));
  set(corner_g12, y1 * y2);
  set(corner_g22, 0.5 * (y2 * y2));
}

void FaceChart::add_ribbon(int side, const Vector2& point, const Jet2& weight, Scratch& scratch) const {
  const int n = sides(), a = side, b = (side + 1) % n;
  const CornerMap out = outgoing(a, point), in = incoming(b, point);
  const Jet2 &before = scratch.distance[std::size_t((side + n - 1) % n)],
             &after = scratch.distance[std::size_t(b)];
  const Jet2 tau = before * reciprocal(before + after);
  const Jet2 blend = compose((3 - 2 * tau.v) * tau.v * tau.v, 6 * tau.v * (1 - tau.v), 6 - 12 * tau.v, tau);
  const Jet2 t = out.t + blend * (in.t - out.t);
  const Jet2 s = straight(a) || straight(b) ? out.s + blend * (in.s - out.s) : out.s;

  Along r0[7], r1[6], r2[4];
  quintic(t.v, r0);
  cubic(t.v, r1);
  linear(t.v, r2);
  const Jet2 once = weight * s, twice = 0.5 * (once * s);
  Jet2 f0[7], f1[6], f2[4];
  for (int i = 0; i < 7; ++i) f0[i] = weight * compose(r0[i].v, r0[i].d, r0[i].dd, t);
  for (int i = 0; i < 6; ++i) f1[i] = once * compose(r1[i].v, r1[i].d, r1[i].dd, t);
  for (int i = 0; i < 4; ++i) f2[i] = twice * compose(r2[i].v, r2[i].d, r2[i].dd, t);

  std::vector<Jet2>& all = scratch.all;
  const auto at = [&](int corner, CornerControl which) -> Jet2& {
    return all[std::size_t(corner_control(corner, which))];
  };
  const double sa = sigma(sine_[std::size_t(a)], straight(a)), sb = sigma(sine_[std::size_t(b)], straight(b));
  at(a, corner_p) += f0[0];
  at(a, corner_g1) += f0[1];
  at(a, corner_g11) += f0[2];
  at(a, corner_g2) += sa * f1[0];
  at(a, corner_g12) += sa * f1[1];
  at(a, corner_g22) += (sa * sa) * f2[0];
  // At b: derivatives in the frame of the edge that closes the corner, seen from b.
  const double c = cosine_[std::size_t(b)], d = sine_[std::size_t(b)];
  const Jet2 g1 = -1.0 * f0[4], g11 = f0[5], g2 = -sb * f1[2], g12 = sb * f1[3], g22 = (sb * sb) * f2[1];
  at(b, corner_p) += f0[3];
  at(b, corner_g1) += c * g1 - d * g2;
  at(b, corner_g2) += d * g1 + c * g2;
  at(b, corner_g11) += (c * c) * g11 - (c * d) * g12 + (d * d) * g22;
  at(b, corner_g12) += (2 * c * d) * g11 + (c * c - d * d) * g12 - (2 * c * d) * g22;
  at(b, corner_g22) += (d * d) * g11 + (c * d) * g12 + (c * c) * g22;
  const auto own = [&](SideControl which) -> Jet2& { return all[std::size_t(side_control(side, which))]; };
  own(side_e0) = f0[6];
  own(side_e1) = f1[4];
  own(side_e1_odd) = f1[5];
  own(side_e2) = f2[2];
  own(side_e2_odd) = f2[3];
  if (!joined(side)) return;
  const auto departs = [&](SideDeparture which) -> Jet2& {
    return all[std::size_t(departure_control(side, which))];
  };
  departs(departs_curve_a) = f0[2];
  departs(departs_cross_a) = f1[1];
  departs(departs_curve_b) = f0[5];
  departs(departs_cross_b) = f1[3];
}

void FaceChart::add_centre(const Vector2& point, const Jet2& weight, std::vector<Jet2>& all) const {
  const double unit = 1 / radius_;
  const Jet2 x = Jet2::linear(point.x() * unit, unit, 0), y = Jet2::linear(point.y() * unit, 0, unit);
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

void FaceChart::basis(int side, const Vector2& point, std::span<Jet2> out, Scratch& scratch) const {
  const int n = sides();
  const std::vector<int>& active = active_[std::size_t(side)];
  std::vector<Jet2>& all = scratch.all;
  all.resize(std::size_t(control_count()));
  for (const int k : active) all[std::size_t(k)] = Jet2{};
  const auto copy = [&] {
    for (std::size_t i = 0; i < active.size(); ++i) out[i] = all[std::size_t(active[i])];
  };
  for (const int corner : {side, (side + 1) % n})
    if ((point - vertex(corner)).squaredNorm() < vertex_radius * vertex_radius) {
      vertex_jet(corner, point, all);
      return copy();
    }

  std::vector<Jet2>& distance = scratch.distance;
  distance.resize(std::size_t(n));
  const auto set_distance = [&](int m) {
    const Vector2 slope = normals_[std::size_t(m)] / apothem_;
    distance[std::size_t(m)] = Jet2::linear(1 + slope.dot(point), slope.x(), slope.y());
  };
  const std::vector<int>& near = near_sides_[std::size_t(side)];
  int reached[64];
  int count = 0;
  for (const int m : near) {
    for (const int k : {(m + n - 1) % n, m, (m + 1) % n}) set_distance(k);
    if (distance[std::size_t(m)].v < reach_ - cut_off && count < 64) reached[count++] = m;
  }
  // w_m ~ (1 - d_m / reach)^3 prod_(k != m) d_k^3, the centre prod_k d_k^3; factors of sides out of reach
  // cancel.
  Jet2 weight[64], centre = Jet2::constant(1), sum = Jet2::constant(0);
  for (int i = 0; i < count; ++i) {
    Jet2 product = cube(Jet2::constant(1) - (1 / reach_) * distance[std::size_t(reached[i])]);
    for (int k = 0; k < count; ++k)
      if (k != i) product = product * cube(distance[std::size_t(reached[k])]);
    weight[i] = product;
    centre = centre * cube(distance[std::size_t(reached[i])]);
    sum += product;
  }
  sum += centre;
  const Jet2 share = reciprocal(sum);
  for (int i = 0; i < count; ++i) add_ribbon(reached[i], point, weight[i] * share, scratch);
  add_centre(point, centre * share, all);
  copy();
}

FaceChart::Curve FaceChart::curve(double t) {
  Along r0[7];
  quintic(t, r0);
  Curve out;
  for (int i = 0; i < 7; ++i) {
    const double sign = i == 4 ? -1 : 1;  // g1 at b looks back along the edge
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
  const double c = cosine_[std::size_t(b)], d = sine_[std::size_t(b)];
  return {seven[0],         seven[1],     seven[2],         seven[3],
          c * seven[4],     d * seven[4], c * c * seven[5], 2 * c * d * seven[5],
          d * d * seven[5], seven[6]};
}

}  // namespace hariko

#include "core/g2/faces/chart_polygon.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/base/solvers/dense_solver.hpp"

namespace hariko {

namespace {

/// Turns of a corner's vertex, in radians: below the first the vertex decides where the chart's corner lies
/// between those beside it, above the second it does not.
constexpr double straight_turn = 0.2, anchor_turn = 0.5;
/// Least distance of a side from the centre, in apothems of the regular polygon.
constexpr double least_apothem = 0.25;
/// Least turn of the chart's corner, as a share of its vertex's or of the regular polygon's, the smaller.
constexpr double least_turn_share = 0.25;
/// Steps of the bisection toward the regular polygon.
constexpr int bisections = 40;

/// Polygon with equal moments of inertia around 0 in all directions and mean side 1; empty where it has no
/// area.
std::vector<Vector2> normalized(std::span<const Vector2> face) {
  const std::size_t n = face.size();
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const Vector2 &a = face[j], &b = face[(j + 1) % n], sum = a + b;
    const double area = cross(a, b);
    xx += area * (a.x() * a.x() + b.x() * b.x() + sum.x() * sum.x());
    xy += area * (a.x() * a.y() + b.x() * b.y() + sum.x() * sum.y());
    yy += area * (a.y() * a.y() + b.y() * b.y() + sum.y() * sum.y());
  }
  const double determinant = xx * yy - xy * xy;
  if (!(xx > 0 && yy > 0 && determinant > 1e-12 * xx * yy)) return {};
  // Reciprocal of the moment's symmetric root: it turns with the polygon.
  const double root = std::sqrt(determinant), trace = std::sqrt(xx + yy + 2 * root);
  const double r11 = (xx + root) / trace, r12 = xy / trace, r22 = (yy + root) / trace;
  std::vector<Vector2> out;
  for (const Vector2& p : face) out.emplace_back(r22 * p.x() - r12 * p.y(), r11 * p.y() - r12 * p.x());
  double length = 0, square = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double side = (out[(j + 1) % n] - out[j]).norm();
    length += side;
    square += side * side;
  }
  for (Vector2& p : out) p *= length / square;
  return out;
}

/// Turns a polygon to where it is nearest to the regular one.
void align(std::vector<Vector2>& polygon, const std::vector<Vector2>& regular) {
  double along = 0, across = 0;
  for (std::size_t j = 0; j < polygon.size(); ++j) {
    along += polygon[j].dot(regular[j]);
    across += cross(polygon[j], regular[j]);
  }
  const double norm = std::hypot(along, across);
  if (!(norm > 0)) return;
  const double c = along / norm, s = across / norm;
  for (Vector2& p : polygon) p = {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

double turn_of(const CornerShape& corner) {
  return is_straight(corner.angle) ? 0 : std::numbers::pi - corner.angle;
}

/// Share of a corner's place that its vertex decides.
double straightness(const CornerShape& corner) {
  return std::clamp((anchor_turn - turn_of(corner)) / (anchor_turn - straight_turn), 0.0, 1.0);
}

/// Places corners that turn little in their vertices as the vertices do, between the corners beside them: at
/// a corner that is almost straight in both charts no other map is close to linear. A linear system; with
/// fewer than three corners that turn there is nothing to lie between.
std::vector<Vector2> straightened(const std::vector<Vector2>& polygon, std::span<const CornerShape> corners,
                                  double share) {
  const auto n = static_cast<Eigen::Index>(polygon.size());
  double turning = 0;
  for (const CornerShape& corner : corners) turning += 1 - straightness(corner);
  share *= std::clamp(turning - 2, 0.0, 1.0);
  if (share == 0 || turning == double(n)) return polygon;
  // Rows of x, then of y, of place - s ((1 - tau) before + tau after), tau complex.
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2 * n, 2 * n);
  Eigen::VectorXd right(2 * n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const CornerShape& corner = corners[std::size_t(j)];
    const double s = share * straightness(corner);
    const std::complex<double> after = std::polar(corner.out / corner.in, turn_of(corner));
    const std::complex<double> tau = 1.0 / (1.0 + after), rest = 1.0 - tau;
    const auto subtract = [&](Eigen::Index at, const std::complex<double>& factor) {
      matrix(j, at) -= s * factor.real();
      matrix(j, n + at) += s * factor.imag();
      matrix(n + j, at) -= s * factor.imag();
      matrix(n + j, n + at) -= s * factor.real();
    };
    subtract((j + n - 1) % n, rest);
    subtract((j + 1) % n, tau);
    right[j] = (1 - s) * polygon[std::size_t(j)].x();
    right[n + j] = (1 - s) * polygon[std::size_t(j)].y();
  }
  // Nearly singular where a run of such corners turns once around: what comes out then does not suit.
  const Eigen::VectorXd places = solve_general(matrix, right);
  std::vector<Vector2> out;
  for (Eigen::Index j = 0; j < n; ++j) out.emplace_back(places[j], places[n + j]);
  return out;
}

/// Whether a chart can lie over the polygon.
bool suits(const std::vector<Vector2>& polygon, std::span<const CornerShape> corners) {
  const std::size_t n = polygon.size();
  const double turn = 2 * std::numbers::pi / double(n),
               apothem = 1 / (2 * std::tan(std::numbers::pi / double(n)));
  for (std::size_t j = 0; j < n; ++j) {
    const Vector2 &a = polygon[j], &b = polygon[(j + 1) % n], side = b - a,
                  before = a - polygon[(j + n - 1) % n];
    if (!(cross(a, b) > least_apothem * apothem * side.norm())) return false;
    const double own = std::atan2(cross(before, side), before.dot(side)), vertex = turn_of(corners[j]);
    if (own < least_turn_share * std::min(vertex, turn) - 1e-9) return false;
  }
  return true;
}

}  // namespace

std::vector<Vector2> regular_chart_polygon(int sides) {
  std::vector<Vector2> out;
  const double radius = 1 / (2 * std::sin(std::numbers::pi / sides));
  for (int j = 0; j < sides; ++j) {
    const double turn = 2 * std::numbers::pi * j / sides;
    out.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
  }
  return out;
}

std::vector<Vector2> chart_polygon(std::span<const Vector2> face, std::span<const CornerShape> corners) {
  const std::vector<Vector2> regular = regular_chart_polygon(int(face.size()));
  std::vector<Vector2> own = normalized(face);
  if (own.empty()) own = regular;
  align(own, regular);
  // 2: the face's own polygon; 1: the regular one, with straight corners; 0: the regular one, which always
  // suits.
  const auto polygon = [&](double at) {
    const double share = std::clamp(at - 1, 0.0, 1.0);
    std::vector<Vector2> mixed;
    for (std::size_t j = 0; j < own.size(); ++j)
      mixed.push_back(share == 1 ? own[j] : Vector2(regular[j] + share * (own[j] - regular[j])));
    return straightened(mixed, corners, std::min(at, 1.0));
  };
  double low = 0, high = 2;
  if (std::vector<Vector2> whole = polygon(high); suits(whole, corners)) return whole;
  for (int i = 0; i < bisections; ++i) {
    const double middle = (low + high) / 2;
    (suits(polygon(middle), corners) ? low : high) = middle;
  }
  return polygon(low);
}

double linear_angle(const CornerShape& corner, const Vector2& at, const Vector2& next,
                    const Vector2& previous) {
  if (is_straight(corner.angle) || corner.centre_distance == 0) return corner.angle;
  const Vector2 forward = next - at, back = previous - at;
  const double own = std::atan2(cross(forward, back), forward.dot(back));
  return corner.angle + straightness(corner) * (own - corner.angle);
}

}  // namespace hariko

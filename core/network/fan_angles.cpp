#include "core/network/fan_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/network/smooth_step.hpp"

namespace hariko {

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_step = 0.1 * degree;
/// Width of the range below its limit in which a step approaches the limit smoothly.
constexpr double soft_range = 4 * degree;
constexpr double first_flat = 150 * degree, full_flat = 170 * degree, most_turn = 10 * degree;
constexpr int limit_rounds = 30;
/// Rims of faces by number of sides: those of fewer sides than `first_rim` keep their corners, those of more
/// than `last_rim` are round already.
constexpr double rim_factor = 4, first_rim = 6, full_rim = 12, last_full_rim = 16, last_rim = 32;

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Angle from a to b in a counter-clockwise triangle, 0 .. pi.
double triangle_angle(const Vector2& a, const Vector2& b) {
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

/// Straightens edge flow lines through a vertex where the corners on both sides of them differ little.
void straighten(std::vector<double>& steps) {
  const std::size_t half = steps.size() / 2;
  double largest = 0;
  for (std::size_t k = 0; k < half; ++k)
    largest = std::max(largest, std::abs(steps[k] - steps[k + half]) / 2);
  const double ratio = largest / (20 * degree), square = ratio * ratio;
  const double share = 0.7 / (1 + square * square);
  for (std::size_t k = 0; k < half; ++k) {
    const double mean = (steps[k] + steps[k + half]) / 2;
    steps[k] += share * (mean - steps[k]);
    steps[k + half] += share * (mean - steps[k + half]);
  }
}

/// Factor by which the turn of a face's rim at its corners is reduced.
double rim_factor_of(Index sides) {
  const double n = double(sides);
  return 1 + (rim_factor - 1) * smooth_step((n - first_rim) / (full_rim - first_rim)) *
                 (1 - smooth_step((n - last_full_rim) / (last_rim - last_full_rim)));
}

/// Straightens the rim of a face of many sides, as an edge flow line; the corners of other faces become
/// smaller. The rim keeps some turn: the split vector moves along the edge by the ratio of the polygon's turn
/// and the fan's.
void straighten_rims(std::vector<double>& steps, std::span<const double> angles,
                     std::span<const Index> sides) {
  constexpr double half_turn = 180 * degree;
  double gained = 0, rest = 0;  // rest: sum of the corners of other faces, which become smaller
  std::vector<double> gain(steps.size(), 0.0);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double factor = rim_factor_of(sides[k]);
    if (factor == 1)
      rest += steps[k];
    else
      gain[k] = std::max(0.0, half_turn - std::max(0.0, half_turn - angles[k]) / factor - steps[k]);
    gained += gain[k];
  }
  if (gained == 0) return;
  const double part = std::min(1.0, rest / (2 * gained));
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (rim_factor_of(sides[k]) > 1)
      steps[k] += part * gain[k];
    else
      steps[k] *= 1 - part * gained / rest;
}

/// Largest step of a corner with this angle in its face. It is lower for reflex corners, whose split edges
/// move faster with the position along an edge.
double limit_of(double angle) {
  return std::max(150 * degree, 178 * degree - 1.5 * std::max(0.0, angle - 180 * degree));
}

void keep_in_limits(std::vector<double>& steps, std::span<const double> angles, double total) {
  const auto within = [&](std::size_t k) {
    return steps[k] >= least_step && steps[k] <= limit_of(angles[k]) - soft_range;
  };
  bool all_within = true;
  for (std::size_t k = 0; k < steps.size(); ++k) all_within = all_within && within(k);
  if (all_within) return;
  for (int round = 0; round < limit_rounds; ++round) {
    double room = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const double limit = limit_of(angles[k]), soft = limit - soft_range;
      double& a = steps[k];
      a = std::max(a, least_step);
      if (a > soft) a = soft + soft_range * std::tanh((a - soft) / soft_range);
      room += (limit - a) * a;
    }
    const double missing = total - sum_of(steps);
    if (std::abs(missing) <= 1e-15 * total || !(room > 0)) break;
    for (std::size_t k = 0; k < steps.size(); ++k)
      steps[k] += missing * (limit_of(angles[k]) - steps[k]) * steps[k] / room;
  }
  const double scale = total / sum_of(steps);
  for (double& a : steps) a *= scale;
}

}  // namespace

double corner_angle(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index corner) {
  // Patches turn counter-clockwise around 0, so both parts are below a half turn.
  const Vector2& p = charts.corner[corner];
  return triangle_angle(charts.corner[mesh.next(corner)] - p, -p) +
         triangle_angle(-p, charts.corner[mesh.previous(corner)] - p);
}

double place_in_corner(const HalfEdgeMesh& mesh, const FaceCharts& charts, Index corner) {
  const Vector2 chord = charts.corner[mesh.next(corner)] - charts.corner[mesh.previous(corner)];
  return triangle_angle(chord, -charts.corner[corner]) / std::numbers::pi;
}

double flat_share(double step, double corner_angle) {
  return smooth_step((step - first_flat) / (full_flat - first_flat)) *
         smooth_step(1 - std::abs(std::numbers::pi - corner_angle) / most_turn);
}

std::vector<double> fan_steps(std::span<const double> angles, std::span<const Index> sides, double total,
                              bool closed) {
  std::vector<double> steps(angles.begin(), angles.end());
  const double scale = total / sum_of(steps);
  for (double& a : steps) a *= scale;
  if (closed && steps.size() >= 4 && steps.size() % 2 == 0) straighten(steps);
  if (closed) straighten_rims(steps, angles, sides);
  return steps;
}

std::vector<double> limited_steps(std::vector<double> steps, std::span<const double> angles, double total) {
  for (double& a : steps) a = std::max(a, least_step);
  const double scale = total / sum_of(steps);
  for (double& a : steps) a *= scale;
  keep_in_limits(steps, angles, total);
  return steps;
}

std::vector<double> turned_steps(std::vector<double> steps, std::span<const double> turns,
                                 std::span<const double> angles, double total) {
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] += turns[k + 1] - turns[k];
  return limited_steps(std::move(steps), angles, total);
}

}  // namespace hariko

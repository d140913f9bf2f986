#include "core/network/short_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/network/fan_angles.hpp"

namespace hariko {

namespace {

/// Share of the longest edge of a fan that keeps lengths from zero, and the one that keeps those of edges
/// without any length.
constexpr double least_share = 0.01, least_of_all = 1e-5;
/// Share of the longest edge below which an edge is kept from zero by less.
constexpr double full_share = 1.0 / 16;
/// Length relative to that of the shortest edge beside it, below which an edge is short.
constexpr double short_ratio = 0.1;
/// Part of what the ends differ by that is taken away: the split vector moves along an edge by the ratio of
/// the turns in the face and in the fan, so that a corner in a face does not become quite straight.
constexpr double agreement = 0.75;
/// Inflation of a fan that counts where there is none.
constexpr double least_gain = std::numbers::pi / 180;

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// The two corners beside an edge at one of its ends.
struct Beside {
  Index left, right;
};

}  // namespace

double fan_length(double length, double longest) {
  const double share = least_share * smooth_step(length / (full_share * longest));
  return std::hypot(length, std::max(share, least_of_all) * longest);
}

std::vector<double> steps_beside_short_edges(const HalfEdgeMesh& mesh, const FaceCharts& charts,
                                             std::span<const Index> corners,
                                             std::span<const double> own_steps) {
  constexpr double full_turn = 2 * std::numbers::pi;
  const std::size_t n = corners.size();
  std::vector<double> steps;
  for (const Index corner : corners) steps.push_back(own_steps[corner]);
  if (n < 3) return steps;
  const auto length = [&](Index h) { return charts.edge_length[mesh.edge(h)]; };
  const auto sum = [&](const Beside& at) { return own_steps[at.left] + own_steps[at.right]; };
  // Angles of a sharp corner are scaled up to a full turn: that is what has to give.
  const auto inflation = [&](const Beside& at) {
    const double seen = corner_angle(mesh, charts, at.left) + corner_angle(mesh, charts, at.right);
    return std::max(0.0, sum(at) - seen) + least_gain;
  };
  for (std::size_t j = 0; j < n; ++j) {
    const Index h = corners[j], twin = mesh.twin(h);
    if (own_steps[twin] == 0) continue;
    const double beside = std::min({length(mesh.previous(h)), length(mesh.next(h)),
                                    length(mesh.previous(twin)), length(mesh.next(twin))});
    if (!(length(h) < short_ratio * beside)) continue;
    const double share = agreement * smooth_step(1 - length(h) / (short_ratio * beside));
    const Beside here{h, mesh.next(twin)}, there{twin, mesh.next(h)};
    const double gain = inflation(here), own = sum(here);
    const double change = share * (full_turn - own - sum(there)) * gain / (gain + inflation(there));
    const std::size_t right = (j + n - 1) % n;
    for (std::size_t i = 0; i < n; ++i)
      steps[i] += i == j || i == right ? change * own_steps[corners[i]] / own
                                       : -change * own_steps[corners[i]] / (full_turn - own);
  }
  return steps;
}

}  // namespace hariko

#include "core/network/short_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/network/fan_angles.hpp"
#include "core/network/smooth_step.hpp"

namespace hariko {

namespace {

/// Length that keeps short edges above zero, relative to the longest edge of the fan, and the one that keeps
/// edges of no length above zero.
constexpr double floor_share = 0.01, zero_share = 1e-3;
/// Length, relative to the longest edge, below which the former decreases.
constexpr double full_share = 1.0 / 16;
/// Length, relative to that of the shortest edge beside it, below which an edge counts as short.
constexpr double short_ratio = 0.1;
/// Part of the difference between the two ends that is removed. Not all of it, since the split vector moves
/// along an edge by the ratio of the turns in the face and in the fan, so that a corner in a face should not
/// become quite straight.
constexpr double agreement = 0.75;
/// Least inflation of a fan, for ends where there is none.
constexpr double least_gain = std::numbers::pi / 180;

/// The two corners beside an edge, at one of its ends.
struct Beside {
  Index left, right;
};

}  // namespace

double fan_length(double length, double longest) {
  const double share = floor_share * smooth_step(length / (full_share * longest));
  return std::hypot(length, std::max(share, zero_share) * longest);
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
  // Inflation: the angles of a sharp corner are scaled up to a full turn, and that end changes more.
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

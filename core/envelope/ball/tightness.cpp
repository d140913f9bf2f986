#include "core/envelope/ball/tightness.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

constexpr double largest_ball = 8;   ///< of the solids' size
constexpr double smallest_ball = 3;  ///< of the rounding
constexpr double new_rounding = 0.02, new_tightness = 0.5;
constexpr double rounding_before = 0.045;

}  // namespace

double solids_size(std::span<const Solid> solids) {
  Eigen::AlignedBox3d box;
  for (const Solid& solid : solids) box.extend(box_of(solid));
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

std::optional<double> ball_radius_at(double tightness, double rounding, double size) {
  if (!(tightness > 0)) return {};
  const double least = smallest_ball * rounding, most = std::max(largest_ball * size, least);
  return least * std::pow(most / least, 1 - std::min(tightness, 1.0));
}

double tightness_of(std::optional<double> radius, double rounding, double size) {
  const double least = smallest_ball * rounding, most = largest_ball * size;
  if (!radius || !(least > 0) || !(most > least)) return 0;
  return std::clamp(1 - std::log(*radius / least) / std::log(most / least), 0.0, 1.0);
}

void choose_ball(EnvelopeInput& input) {
  EnvelopeSettings& settings = input.settings;
  const double size = solids_size(input.solids);
  settings.method = EnvelopeMethod::ball;
  settings.rounding = new_rounding * size;
  settings.ball_radius = ball_radius_at(new_tightness, settings.rounding, size);
}

void choose_ball_as_before(EnvelopeInput& input, double tightness) {
  EnvelopeSettings& settings = input.settings;
  const double size = solids_size(input.solids);
  settings.method = EnvelopeMethod::ball;
  settings.rounding = rounding_before * size;
  settings.ball_radius = ball_radius_at(tightness, settings.rounding, size);
}

}  // namespace hariko

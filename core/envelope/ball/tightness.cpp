#include "core/envelope/ball/tightness.hpp"

#include <algorithm>
#include <cmath>

#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/grown_solids.hpp"
#include "core/envelope/scene_symmetry.hpp"

namespace hariko {

namespace {

constexpr double largest_ball = 8;                          ///< radius relative to the solids' size
constexpr double new_rounding = 0.02, new_tightness = 0.5;  ///< new objects: a cylinder stays a cylinder
constexpr double rounding_before = 0.045;                   ///< rounding of surfaces before method `ball`
constexpr int join_rounds = 8;                              ///< bisections, 1/256 of the range is left

int part_count(const EnvelopeInput& input) {
  const EnvelopedScene scene = enveloped_scene(input);
  const BallSettings settings = ball_settings(input.settings, solids_size(scene.input.solids));
  const BallField field =
      ball_field(scene.input.solids, settings, scene.origin, scene.mirror, Quality::final);
  return topology_of(cage_of(field, scene.origin, settings.sigma)).components;
}

/// Sets the ball; `rounding` is relative to the solids' size.
void set_ball(EnvelopeInput& input, double rounding, double tightness) {
  EnvelopeSettings& settings = input.settings;
  const double size = solids_size(input.solids);
  settings.method = EnvelopeMethod::ball;
  settings.rounding = rounding * size;
  settings.ball_radius = ball_radius_at(tightness, settings.rounding, size);
}

}  // namespace

double solids_size(std::span<const Solid> solids) {
  Eigen::AlignedBox3d box;
  for (const Solid& solid : solids) {
    box.extend(box_of(solid));
    for (const Pull& pull : solid.pulls) box.extend(placed(solid, pull.place));
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

std::optional<double> ball_radius_at(double tightness, double rounding, double size) {
  if (!(tightness > 0)) return {};
  const double least = least_ball * rounding, most = std::max(largest_ball * size, least);
  return least * std::pow(most / least, 1 - std::min(tightness, 1.0));
}

double tightness_of(std::optional<double> radius, double rounding, double size) {
  const double least = least_ball * rounding, most = largest_ball * size;
  if (!radius || !(least > 0) || !(most > least)) return 0;
  return std::clamp(1 - std::log(*radius / least) / std::log(most / least), 0.0, 1.0);
}

void choose_ball(EnvelopeInput& input) {
  set_ball(input, new_rounding, new_tightness);
}

void choose_ball_as_before(EnvelopeInput& input, double tightness) {
  set_ball(input, rounding_before, tightness);
}

double faces_outside(const Solid& solid, const EnvelopeSettings& settings, double size) {
  const BallSettings ball = ball_settings(settings, size);
  const double growth = constant_of(solid, ball.sigma, ball.on_faces) + room_outside(ball);
  // The growth of a solid with a roundness of its own also compensates for faces that were moved inwards.
  const SolidShape shape(solid, solid.position), followed(softened(solid), solid.position);
  return growth - face_constant(shape, solid.roundness ? followed : shape, ball.sigma);
}

bool join_parts(EnvelopeInput& input) {
  EnvelopeInput trial = input;
  if (part_count(trial) <= 1) return false;
  const double size = solids_size(input.solids);
  double low = std::log(ball_settings(input.settings, size).radius);
  double high = std::max(low, std::log(largest_ball * size));
  std::optional<double> joined;
  const auto joins = [&](double exponent) {
    trial.settings.ball_radius = std::exp(exponent);
    if (part_count(trial) > 1) return false;
    joined = trial.settings.ball_radius;
    return true;
  };
  // The hull alone joins parts that the largest ball does not.
  if (joins(high))
    for (int round = 0; round < join_rounds; ++round) {
      const double middle = 0.5 * (low + high);
      (joins(middle) ? high : low) = middle;
    }
  input.settings.ball_radius = joined;
  return true;
}

}  // namespace hariko

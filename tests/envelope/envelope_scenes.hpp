#pragma once

// The scenes of tests/golden/envelope, and random ones.

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "core/document/format/read_solids.hpp"
#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/envelope.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

inline EnvelopeInput golden_scene(const std::string& name) {
  std::ifstream file(test::source_folder() + "/tests/golden/envelope/" + name + ".json");
  std::ostringstream text;
  text << file.rdbuf();
  const auto scene = read_scene(text.str());
  if (!scene) ADD_FAILURE() << name << ": " << to_string(scene.error());
  if (!scene) return {};
  EnvelopeInput out = *scene;
  // They are from before there was the ball; its own tests choose it.
  out.settings.method = EnvelopeMethod::network;
  out.settings.converted.method = false;
  out.settings.converted.lost.clear();
  return out;
}

/// From a cold start.
inline EnvelopeSurface envelope_of(const EnvelopeInput& input) {
  auto made = EnvelopeSurfacer().rebuild(input);
  if (!made) ADD_FAILURE() << to_string(made.error());
  return made ? std::move(made).value() : EnvelopeSurface{};
}

/// Scene of method `ball`.
inline EnvelopeInput ball_scene(std::vector<Solid> solids, double rounding, std::optional<double> radius) {
  EnvelopeInput out{std::move(solids), {}};
  out.settings.method = EnvelopeMethod::ball;
  out.settings.rounding = rounding;
  out.settings.ball_radius = radius;
  return out;
}

/// Envelope of such a scene. `memory`: of the frames before, or null.
inline BallEnvelope made_ball(const EnvelopeInput& input, Quality quality = Quality::final,
                              BallMemory* memory = nullptr) {
  const EnvelopedScene scene = enveloped_scene(input);
  auto made =
      ball_envelope(scene.input.solids, ball_settings(input.settings, solids_size(scene.input.solids)),
                    scene.origin, scene.mirror, quality, {}, memory);
  if (!made) ADD_FAILURE() << "there is no surface";
  return made ? *std::move(made) : BallEnvelope{};
}

/// 1 .. 20 solids of all kinds, half sizes log-uniform from 0.2 to 1, of which about 70 % touch another one.
inline EnvelopeInput random_scene(std::mt19937_64& rng) {
  EnvelopeInput out;
  const int count = uniform_int(rng, 1, 20);
  for (int k = 0; k < count; ++k) {
    Solid solid;
    solid.kind = SolidKind(uniform_int(rng, 0, 8));
    const auto half = [&] { return log_uniform(rng, 0.2, 1); };
    solid.size = {2 * half(), 2 * half(), 2 * half()};
    solid.radius = half();
    solid.height = 2 * half();
    solid.length = 2 * half();
    solid.tube = solid.radius * uniform(rng, 0.2, 0.6);
    solid.sides = std::uint32_t(uniform_int(rng, 3, 8));
    solid.id = std::uint32_t(k);
    if (solid.kind == SolidKind::polyhedron)
      for (int i = 0; i < 8; ++i) solid.points.push_back(random_vector(rng, solid.radius));
    solid.rotation = random_vector(rng, 180);
    if (k > 0) {
      const Solid& other = out.solids[std::size_t(uniform_int(rng, 0, k - 1))];
      const Vector3 direction = random_vector(rng).normalized();
      solid.position =
          other.position + direction * (chance(rng, 0.7) ? uniform(rng, 0.3, 1.0) : uniform(rng, 2.0, 3.0));
    }
    out.solids.push_back(solid);
  }
  return out;
}

inline bool warned(const EnvelopeSurface& made, Code code) {
  return std::any_of(made.warnings.begin(), made.warnings.end(),
                     [&](const Message& message) { return message.code == code; });
}

/// In a radian.
inline constexpr double degrees = 180 / std::numbers::pi;

}  // namespace hariko::test

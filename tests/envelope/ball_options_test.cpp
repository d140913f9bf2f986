// Options of a ball's surface: faces that lie on the solids, finer patches, a bridge's own ball.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

Solid option_box(const Vector3& size, const Vector3& at = Vector3::Zero(), std::uint32_t id = 0) {
  Solid out;
  out.size = size;
  out.position = at;
  out.id = id;
  return out;
}

EnclosureReport option_judged(const EnvelopeInput& input, const EnvelopeSurface& made) {
  std::vector<SolidShape> shapes;
  for (const Solid& solid : input.solids) shapes.emplace_back(solid, made.origin);
  const double size = solids_size(input.solids);
  return check_enclosure(made.surface, shapes, {.spacing = 2e-3 * size}, 1e-5 * size);
}

/// Points of all patches, relative to the object's zero.
std::vector<Vector3> samples_of(const Surface& surface) {
  std::vector<Vector3> out;
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; j <= 6; ++j)
        out.push_back(surface.patches().evaluate(p, Vector2(i / 6.0, j / 6.0), Order::first).position +
                      surface.origin());
  return out;
}

/// All of a surface's numbers at some places.
bool same_bits(const Surface& a, const Surface& b) {
  return a.patch_count() == b.patch_count() && a.origin() == b.origin() && samples_of(a) == samples_of(b);
}

/// Two boxes with a gap, a bar between them, and a third box elsewhere.
EnvelopeInput bridged_scene(double ball, std::optional<double> own) {
  const Solid a = option_box({1, 1, 1}, {0, 0, 0}, 3), b = option_box({1, 1, 1}, {1.8, 0, 0}, 5);
  Solid bar = bridge_between(a, b, 0.15);
  bar.id = 9;
  bar.bridge->ball_radius = own;
  return ball_scene({a, b, bar, option_box({1, 1, 1}, {-0.8, 0, 1.9}, 11)}, 0.04, ball);
}

double field_at(const EnvelopeInput& input, const Vector3& at) {
  const EnvelopedScene scene = enveloped_scene(input);
  const BallField made =
      ball_field(scene.input.solids, ball_settings(input.settings, solids_size(input.solids)), scene.origin,
                 scene.mirror, Quality::final);
  return made.field.value(at - scene.origin);
}

/// From a point inside along y to the surface.
double height_at(const EnvelopeInput& input, const Vector3& from) {
  const EnvelopedScene scene = enveloped_scene(input);
  const BallField made =
      ball_field(scene.input.solids, ball_settings(input.settings, solids_size(input.solids)), scene.origin,
                 scene.mirror, Quality::final);
  double low = 0, high = 2;
  for (int round = 0; round < 40; ++round) {
    const double y = 0.5 * (low + high);
    (made.field.value(from + y * Vector3::UnitY() - scene.origin) < 0 ? low : high) = y;
  }
  return low;
}

}  // namespace

TEST(OnTheFaces, FlatFacesLieOnThoseOfTheSolids) {
  const double sigma = 0.03;
  for (const double clearance : {0.0, 0.05})
    for (const bool round : {false, true}) {
      EnvelopeInput input =
          ball_scene({option_box({1.6, 1.2, 1}), option_box({1, 1.2, 1}, {1.3, 0, 0.3}, 1)}, sigma, 0.3);
      input.settings.clearance = clearance;
      input.settings.on_faces = true;
      if (round) input.solids[0].roundness = 0.2;
      const BallEnvelope made = made_ball(input);
      // Above the first box, away from its edges and from the other one.
      const double away = round ? 0.3 : 6 * sigma;
      std::size_t seen = 0;
      for (const Vector3& p : samples_of(made.surface))
        if (p.z() < 0 && std::abs(p.x()) < 0.8 - away && std::abs(p.y()) < 0.6 - away) {
          EXPECT_NEAR(p.z(), -0.5 - clearance, 2e-3 * sigma) << round;
          ++seen;
        }
      EXPECT_GE(seen, 50U);
      const double size = solids_size(input.solids);
      EXPECT_NEAR(faces_outside(input.solids[0], input.settings, size), clearance, 1e-9);
      EXPECT_NEAR(faces_outside(input.solids[1], input.settings, size), clearance, 1e-9);
    }
}

TEST(OnTheFaces, FacesOfAllKindsLieOnTheSurface) {
  const double sigma = 0.02;
  for (const SolidKind kind : {SolidKind::box, SolidKind::cylinder, SolidKind::cone, SolidKind::prism,
                               SolidKind::pyramid, SolidKind::polyhedron}) {
    SCOPED_TRACE(name_of(kind));
    Solid solid = option_box({1, 1.2, 0.8}, {0.2, 0.1, -0.3});
    solid.kind = kind;
    solid.scale = {1.2, 1, 1.4};
    solid.rotation = {20, 50, -30};
    if (kind == SolidKind::polyhedron)
      for (int i = 0; i < 8; ++i)
        solid.points.push_back(0.5 * Vector3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    EnvelopeInput input = ball_scene({solid}, sigma, 0.3);
    input.settings.on_faces = true;
    const EnvelopedScene scene = enveloped_scene(input);
    const BallEnvelope made = made_ball(input);
    const SolidShape shape(solid, scene.origin);
    ASSERT_FALSE(shape.face_middles().empty());
    for (const Vector3& middle : shape.face_middles()) {
      EXPECT_NEAR(shape.own_distance(middle), 0, 1e-12);
      EXPECT_NEAR(made.field.value(shape.from_own_axes(middle)), 0, 0.01 * sigma);
    }
  }
}

TEST(OnTheFaces, WhatSticksOutIsWhatTheJudgeFinds) {
  for_random(5, 3, [](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    choose_ball(input);
    input.settings.on_faces = true;
    const EnvelopeSurface made = envelope_of(input);
    ASSERT_TRUE(made.sticks_out.has_value());
    const EnclosureReport judged = option_judged(input, made);
    const double tolerance = patch_tolerance * input.settings.rounding;
    EXPECT_GE(*made.sticks_out, judged.worst - tolerance);
    // The judge knows the nearest foot, and looks at other points.
    EXPECT_LE(*made.sticks_out, 1.2 * judged.worst + tolerance);
    // Scenes of balls alone touch their own surface.
    if (judged.worst > 2 * tolerance) {
      EXPECT_FALSE(made.enclosed);
    }
    EXPECT_FALSE(warned(made, w_not_enclosed)) << "it was asked for";
    EXPECT_EQ(made.folds, 0U);
  });
}

TEST(OnTheFaces, EdgesOfABoxStickOutByTheRounding) {
  const double sigma = 0.03;
  EnvelopeInput input = ball_scene({option_box({1, 1, 1})}, sigma, 0.3);
  input.settings.on_faces = true;
  const Vector3 diagonal = Vector3(1, 1, 0).normalized();
  double low = 0, high = 1;
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    (field_at(input, middle * diagonal) < 0 ? low : high) = middle;
  }
  // The mean of a quarter space's distance under a Gaussian of width 1 is zero 0.808 inside of the edge.
  EXPECT_NEAR((std::sqrt(0.5) - low) / sigma, 0.808, 0.02);
  // Corners do most.
  EXPECT_NEAR(made_ball(input).sticks_out / sigma, 1.46, 0.05);
}

TEST(OnTheFaces, ABallTouchesItsOwnSurface) {
  Solid ball = option_box({1, 1, 1});
  ball.kind = SolidKind::sphere;
  EnvelopeInput input = ball_scene({ball}, 0.03, 0.3);
  input.settings.on_faces = true;
  for (const Vector3& p : samples_of(made_ball(input).surface)) EXPECT_NEAR(p.norm(), 0.5, 0.02 * 0.03);
}

TEST(OnTheFaces, ThinSolidsDoNotVanish) {
  // A sheet half as thick as the kernel is wide, and a needle: means of their distances are positive.
  for (const Vector3& size : {Vector3(2, 1.5, 0.02), Vector3(2, 0.02, 0.02)}) {
    EnvelopeInput input = ball_scene({option_box(size)}, 0.04, 0.3);
    input.settings.on_faces = true;
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_GT(made.surface.patch_count(), 0U);
    EXPECT_EQ(made.components, 1);
    EXPECT_EQ(made.folds, 0U);
    double above = 0;
    for (const Vector3& p : samples_of(made.surface))
      if (std::abs(p.x()) < 0.3 && std::abs(p.y()) < 0.4) above = std::max(above, p.z());
    EXPECT_GT(above, 0.5 * 0.04);
    EXPECT_LT(above, 2 * 0.04);
  }
}

TEST(OnTheFaces, EnclosingStaysTheDefault) {
  const EnvelopeInput input = ball_scene({option_box({1, 1, 1})}, 0.03, 0.3);
  EXPECT_FALSE(input.settings.on_faces);
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_TRUE(made.enclosed);
  EXPECT_FALSE(made.sticks_out.has_value());
}

TEST(FinerPatches, AreMoreAndNearerToTheSameShape) {
  for (const char* name : {"four", "ell"}) {
    EnvelopeInput input = golden_scene(name);
    choose_ball(input);
    input.settings.rounding = 0.035 * solids_size(input.solids);
    const BallEnvelope usual = made_ball(input);
    input.settings.finer_patches = true;
    const BallEnvelope finer = made_ball(input);
    const double patches = double(finer.surface.patch_count()) / double(usual.surface.patch_count());
    EXPECT_GE(patches, 1.6) << name;
    EXPECT_LE(patches, 2.6) << name;
    const double before = std::max(usual.outward, usual.inward), now = std::max(finer.outward, finer.inward);
    EXPECT_LE(now, 0.6 * before) << name;
    EXPECT_EQ(finer.folds, 0U);
    EXPECT_EQ(finer.coarse, 0U);
    // The same field: only the patches differ.
    for (const Vector3& p : usual.cage.positions) EXPECT_EQ(usual.field.value(p), finer.field.value(p));
    std::printf("%s: patches %u -> %u, deviation %.3f -> %.3f sigma\n", name, usual.surface.patch_count(),
                finer.surface.patch_count(), before / input.settings.rounding, now / input.settings.rounding);
  }
}

TEST(BridgeBalls, ASmallerBallFreesTheGapOfItsBridgeAlone) {
  // The ball fills the gap between the boxes; that of the bridge leaves a bar there.
  const Vector3 beside_the_bar(0.9, 0.38, 0), other_gap(-0.4, 0, 0.95);
  const EnvelopeInput without = bridged_scene(2, {}), with = bridged_scene(2, 0.2);
  EXPECT_LT(field_at(without, beside_the_bar), 0);
  EXPECT_GT(field_at(with, beside_the_bar), 0);
  EXPECT_LT(field_at(with, {0.9, 0, 0}), 0) << "the bar is there";
  EXPECT_GT(height_at(without, other_gap), 0.2) << "the other gap is not filled";
  EXPECT_NEAR(height_at(with, other_gap), height_at(without, other_gap), 1e-3) << "another gap changes";
  const EnvelopeSurface made = envelope_of(with);
  EXPECT_TRUE(made.enclosed);
  EXPECT_EQ(made.folds, 0U);
  EXPECT_EQ(option_judged(with, made).outside, 0U);
}

TEST(BridgeBalls, ALargerBallRoundsTheEndsOfItsBar) {
  const Vector3 at_the_end(0.62, 0.3, 0);
  const EnvelopeInput without = bridged_scene(0.13, {}), with = bridged_scene(0.13, 0.5);
  EXPECT_GT(field_at(without, at_the_end), 0);
  EXPECT_LT(field_at(with, at_the_end), 0);
  const EnvelopeSurface made = envelope_of(with);
  EXPECT_TRUE(made.enclosed);
  EXPECT_EQ(made.folds, 0U);
  EXPECT_EQ(option_judged(with, made).outside, 0U);
}

TEST(BridgeBalls, GoSteadilyAsTheirRadiusGrows) {
  // Wider than the gap all the way, and on to beyond the radius of the usual ball.
  double before = 0, largest = 0, first = 0;
  for (int k = 0; k <= 18; ++k) {
    const double now = height_at(bridged_scene(0.6, 0.42 + 0.04 * k), {0.9, 0, 0});
    if (k > 0) {
      EXPECT_GE(now, before - 5e-3) << k << ": a larger ball fills less";
      largest = std::max(largest, now - before);
    } else {
      first = now;
    }
    before = now;
  }
  EXPECT_GE(before - first, 0.1) << "the bridge did not grow";
  EXPECT_LE(largest, 0.06) << "it jumps";
  EXPECT_NEAR(height_at(bridged_scene(0.6, 0.6), {0.9, 0, 0}), height_at(bridged_scene(0.6, {}), {0.9, 0, 0}),
              1e-4);
}

TEST(BridgeBalls, SurfacesContainTheSolidsWhateverTheyAre) {
  for_random(11, 4, [](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    choose_ball(input);
    input.settings.rounding *= 1.5;
    for (int k = 0; k < 2; ++k) {
      const int count = int(input.solids.size());
      const Solid& a = input.solids[std::size_t(uniform_int(rng, 0, count - 1))];
      const Solid& b = input.solids[std::size_t(uniform_int(rng, 0, count - 1))];
      if (a.id == b.id) continue;
      Solid bar = bridge_between(a, b, 0.15);
      bar.id = std::uint32_t(100 + k);
      bar.bridge->ball_radius = log_uniform(rng, 0.1, 3);
      input.solids.push_back(bar);
    }
    if (chance(rng, 0.5)) input.settings.symmetry = SymmetryPlane::x;
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_EQ(made.folds, 0U);
    EXPECT_EQ(option_judged(input, made).outside, 0U);
  });
}

TEST(BridgeBalls, ABridgeWithoutItsOwnBallIsASolidLikeAnyOther) {
  EnvelopeInput bridged = bridged_scene(0.4, {});
  const EnvelopeSurface with = envelope_of(bridged);
  bridged.solids[2].bridge.reset();
  EXPECT_TRUE(same_bits(with.surface, envelope_of(bridged).surface));
}

}  // namespace hariko::test

// Designers' controls of a ball's surface beyond its two lengths: roundness of a solid, bridges, parts that
// are joined; and places where it could jump or pinch.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/envelope/ball/ball_envelope.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "core/envelope/scene_symmetry.hpp"
#include "tests/envelope/envelope_scenes.hpp"

namespace hariko::test {

namespace {

Solid box_at(const Vector3& size, const Vector3& at) {
  Solid out;
  out.size = size;
  out.position = at;
  return out;
}

Solid ball_at(double radius, const Vector3& at) {
  Solid out;
  out.kind = SolidKind::sphere;
  out.radius = radius;
  out.position = at;
  return out;
}

EnvelopeInput scene_of(std::vector<Solid> solids, double rounding, double radius) {
  EnvelopeInput out{std::move(solids), {}};
  for (std::size_t i = 0; i < out.solids.size(); ++i) out.solids[i].id = std::uint32_t(i);
  out.settings.method = EnvelopeMethod::ball;
  out.settings.rounding = rounding;
  out.settings.ball_radius = radius;
  return out;
}

BallField field_of(const EnvelopeInput& input, Vector3& origin) {
  const EnvelopedScene scene = enveloped_scene(input);
  origin = scene.origin;
  return ball_field(scene.input.solids, ball_settings(input.settings, solids_size(input.solids)),
                    scene.origin, scene.mirror, Quality::final);
}

/// From a point inside along a direction to the surface.
double height_over(const EnvelopeInput& input, const Vector3& from, const Vector3& direction, double far) {
  Vector3 origin;
  const BallField field = field_of(input, origin);
  double low = 0, high = far;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    (field.field.value(from - origin + middle * direction) < 0 ? low : high) = middle;
  }
  return low;
}

EnclosureReport judged(const EnvelopeInput& input, const EnvelopeSurface& made) {
  std::vector<SolidShape> shapes;
  for (const Solid& solid : input.solids) shapes.emplace_back(solid, made.origin);
  const double size = solids_size(input.solids);
  return check_enclosure(made.surface, shapes, {.spacing = 0.01 * size}, 1e-4 * size);
}

}  // namespace

TEST(BallControls, ASlotFillsInSteps) {
  // A trough between two walls: a single ball leaves it at once, by two thirds of its depth.
  EnvelopeInput input = scene_of({box_at({4, 1.9, 0.2}, {0, 0, 0.1}), box_at({4, 0.2, 2}, {0, 0.85, 1}),
                                  box_at({4, 0.2, 2}, {0, -0.85, 1})},
                                 0.1, 0.45);
  const double size = solids_size(input.solids), step = 0.004 * size;
  double before = height_over(input, {0, 0, 0.1}, Vector3::UnitZ(), 4), first = before, largest = 0;
  for (; *input.settings.ball_radius < 1; *input.settings.ball_radius += step) {
    const double now = height_over(input, {0, 0, 0.1}, Vector3::UnitZ(), 4);
    EXPECT_GE(now, before - 1e-3 * size) << "a larger ball fills less";
    largest = std::max(largest, now - before);
    before = now;
  }
  EXPECT_GE(before - first, 1) << "the slot is not filled in the end";
  // Four of the five steps are nearly as large as a fifth of the depth.
  EXPECT_LE(largest, 0.1 * size);
}

TEST(BallControls, NecksAreThereOrNot) {
  // Two balls that part: the neck between them would be as thin as can be at some distance.
  std::size_t pinches = 0;
  int most = 0, fewest = 9;
  for (int k = 0; k <= 24; ++k) {
    const EnvelopeInput input =
        scene_of({ball_at(0.5, {0, 0, 0}), ball_at(0.4, {1.0 + 0.015 * k, 0.1, 0.05})}, 0.06, 0.2);
    Vector3 origin;
    pinches += field_of(input, origin).pinches;
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_EQ(made.folds, 0U) << k;
    EXPECT_EQ(made.coarse, 0U) << k;
    EXPECT_TRUE(made.enclosed) << k;
    most = std::max(most, made.components);
    fewest = std::min(fewest, made.components);
  }
  EXPECT_EQ(fewest, 1);
  EXPECT_EQ(most, 2);
  EXPECT_GE(pinches, 1U) << "no neck came near";
}

TEST(BallControls, TightScenesDoNotFold) {
  // The smallest balls leave the most cubes of different sizes, short sides and thin necks.
  for_random(3, 4, [](std::mt19937_64& rng) {
    EnvelopeInput input = random_scene(rng);
    const double size = solids_size(input.solids);
    input.settings.method = EnvelopeMethod::ball;
    input.settings.rounding = 0.025 * size;
    input.settings.ball_radius = ball_radius_at(chance(rng, 0.5) ? 1 : 0.75, input.settings.rounding, size);
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_EQ(made.folds, 0U);
    EXPECT_TRUE(made.enclosed);
    EXPECT_EQ(judged(input, made).outside, 0U);
  });
}

TEST(BallControls, ATipBetweenThePointsOfLargeCubesIsCovered) {
  // One patch ran below the tip of a pyramid, and three rounds of halving ended with one crowded patch above
  // it.
  std::mt19937_64 rng(2563127032);
  EnvelopeInput input = random_scene(rng);
  const double size = solids_size(input.solids);
  input.settings.method = EnvelopeMethod::ball;
  input.settings.rounding = 0.025 * size;
  input.settings.ball_radius = 3 * input.settings.rounding;
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_EQ(made.folds, 0U);
  EXPECT_EQ(made.coarse, 0U);
  EXPECT_TRUE(made.enclosed);
  EXPECT_EQ(judged(input, made).outside, 0U);
}

TEST(BallControls, NoSolidIsTooSmallForASurface) {
  // Much smaller than the rounding: its surface is a ball of half of the rounding, and fits between the
  // points at which large cubes are looked at.
  const auto check = [](const Vector3& at) {
    SCOPED_TRACE(testing::Message() << at.transpose());
    const EnvelopeInput input = scene_of({box_at({1, 0.8, 0.6}, {0, 0, 0}), ball_at(0.0005, at)}, 0.03, 0.09);
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_EQ(made.components, 2);
    EXPECT_TRUE(made.enclosed);
    EXPECT_EQ(judged(input, made).outside, 0U);
  };
  check({0.83146099682365604, -0.08368995095986341, 0.011927898686318855});
  check({0.83403586705040333, 0.026382805359134009, -0.012648939885476371});
  for_random(4, 3, [&](std::mt19937_64& rng) { check(Vector3(0.8, 0, 0) + random_vector(rng, 0.1)); });
}

TEST(BallControls, AHollowIsFilled) {
  std::vector<Solid> walls;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vector3 size = Vector3::Constant(2.2);
      size[axis] = 0.2;
      walls.push_back(box_at(size, side * Vector3::Unit(axis)));
    }
  const EnvelopeInput input = scene_of(std::move(walls), 0.06, 0.3);
  const EnvelopeSurface made = envelope_of(input);
  EXPECT_EQ(made.components, 1);
  EXPECT_EQ(made.tunnels, 0);
  EXPECT_EQ(made.folds, 0U);
  for (const Vector3& p : made.cage->positions) {
    EXPECT_TRUE(p.allFinite());
    EXPECT_GE((p + made.origin).cwiseAbs().maxCoeff(), 1.1) << "a patch lies inside";
  }
}

TEST(BallControls, ASolidCanBeRounderThanTheOthers) {
  for (const SolidKind kind :
       {SolidKind::box, SolidKind::cylinder, SolidKind::cone, SolidKind::prism, SolidKind::pyramid}) {
    SCOPED_TRACE(name_of(kind));
    Solid one = box_at({1, 0.8, 0.6}, {0, 0, 0});
    one.kind = kind;
    one.rotation = {20, 40, 10};
    one.scale = {1, 1.3, 0.9};
    Solid other = box_at({0.5, 0.5, 0.5}, {3, 0, 0});
    EnvelopeInput input = scene_of({one, other}, 0.05, 0.3);
    const Vector3 side = Vector3::UnitX();
    const double plain = height_over(input, other.position, side, 2);
    input.solids[0].roundness = 0.5;
    const EnvelopeSurface made = envelope_of(input);
    EXPECT_TRUE(made.enclosed);
    EXPECT_EQ(made.folds, 0U);
    EXPECT_EQ(judged(input, made).outside, 0U);
    EXPECT_NEAR(height_over(input, other.position, side, 2), plain, 1e-9) << "the other one has changed";
  }
}

TEST(BallControls, FacesLieAsFarOutsideAsIsSaid) {
  for (const double own : {0.0, 0.2, 0.6}) {
    EnvelopeInput input = scene_of({box_at({2, 1.6, 1.2}, {0.3, 0.2, 0.1})}, 0.04, 0.5);
    input.settings.clearance = 0.03;
    if (own > 0) input.solids[0].roundness = own;
    const double size = solids_size(input.solids);
    const double said = faces_outside(input.solids[0], input.settings, size);
    const double found = height_over(input, input.solids[0].position, Vector3::UnitZ(), 3) - 0.6;
    EXPECT_NEAR(said, found, 0.01 * input.settings.rounding) << own;
    EXPECT_GT(said, input.settings.clearance);
  }
}

TEST(Bridges, RunFromSolidToSolid) {
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const Vector3 shift = Vector3::Constant(scale == 1 ? 1e6 : 0);
    const Solid a = box_at(scale * Vector3(1, 2, 3), shift);
    const Solid b = ball_at(0.5 * scale, shift + scale * Vector3(3, 1, -2));
    const Solid bar = bridge_between(a, b, 0.1 * scale);
    EXPECT_EQ(bar.kind, SolidKind::capsule);
    EXPECT_EQ(bar.radius, 0.1 * scale);
    ASSERT_TRUE(check_solid(bar, 0).ok());
    const Vector3 half = solid_rotation(bar.rotation) * Vector3(0, 0, 0.5 * bar.length);
    const SolidShape from(a, shift), to(b, shift);
    const Vector3 middle = bar.position - shift;
    // Within the solids or on them, and no detour.
    EXPECT_LE(from.distance(middle - half), 1e-6 * scale);
    EXPECT_LE(to.distance(middle + half), 1e-6 * scale);
    EXPECT_LE(bar.length, from.distance(to.centre()) + scale);
  }
}

TEST(Bridges, GoSteadilyWithTheirSolids) {
  // Sides that lie opposite to each other have no nearest points; the bar goes along all the same.
  const Solid a = box_at({4, 4, 1}, {0, 0, 0});
  Vector3 before = Vector3::Zero();
  for (int k = 0; k <= 40; ++k) {
    Solid b = box_at({2, 2, 1}, {-4 + 0.2 * k, 0.3, 3});
    b.rotation = {0, 1e-3 * (k % 2), 0};
    const Vector3 now = bridge_between(a, b, 0.2).position;
    if (k > 0) {
      EXPECT_LE((now - before).norm(), 0.3) << k;
    }
    before = now;
  }
  // Solids that run into each other have a bar, too.
  EXPECT_TRUE(check_solid(bridge_between(a, box_at({1, 1, 1}, {0.2, 0, 0}), 0.2), 0).ok());
}

TEST(JoinedParts, TheBallIsTheSmallestThatJoins) {
  EnvelopeInput input = scene_of({box_at({1, 1, 1}, {0, 0, 0}), ball_at(0.4, {1.6, 0.2, 0})}, 0.05, 0.2);
  EXPECT_EQ(envelope_of(input).components, 2);
  ASSERT_TRUE(join_parts(input));
  ASSERT_TRUE(input.settings.ball_radius.has_value());
  EXPECT_EQ(envelope_of(input).components, 1);
  const EnvelopeInput joined = input;
  EXPECT_FALSE(join_parts(input)) << "it is one part already";
  EXPECT_EQ(input, joined);
  *input.settings.ball_radius *= 0.95;
  EXPECT_EQ(envelope_of(input).components, 2) << "a smaller ball joins them";
}

}  // namespace hariko::test

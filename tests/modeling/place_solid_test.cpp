#include "core/modeling/objects/place_solid.hpp"

#include "core/envelope/solid_shape.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

Solid random_solid(std::mt19937_64& rng) {
  Solid solid;
  solid.kind = SolidKind(uniform_int(rng, 0, 7));
  solid.size = {uniform(rng, 0.3, 2), uniform(rng, 0.3, 2), uniform(rng, 0.3, 2)};
  solid.radius = uniform(rng, 0.3, 2);
  solid.height = uniform(rng, 0.3, 2);
  solid.length = uniform(rng, 0.3, 2);
  solid.tube = solid.radius * uniform(rng, 0.2, 0.8);
  solid.sides = std::uint32_t(uniform_int(rng, 3, 9));
  return solid;
}

}  // namespace

TEST(PlaceSolid, ASolidStandsOnItsPlaceWhicheverWayItIsTurned) {
  for_random(11, 40, [](std::mt19937_64& rng) {
    const Solid solid = random_solid(rng);
    const Vector3 at = random_vector(rng, 3), up = random_vector(rng).normalized();
    const SolidShape on(standing_on(solid, at, up), Vector3::Zero());
    double lowest = 1e300;
    for (const Vector3& p : on.surface_points(2000)) lowest = std::min(lowest, (p - at).dot(up));
    for (const SharpCurve& curve : on.sharp_curves())
      for (const double share : {0.0, 0.5, 1.0}) lowest = std::min(lowest, (curve.at(share) - at).dot(up));
    EXPECT_NEAR(lowest, 0, 0.05);
    EXPECT_GE(lowest, -1e-9);
  });
}

TEST(PlaceSolid, StraightUpASolidIsNotTurned) {
  Solid box;
  box.rotation = {10, 20, 30};
  EXPECT_EQ(standing_on(box, {1, 2, 0}, Vector3::UnitZ()).rotation, Vector3::Zero().eval());
  EXPECT_LT((standing_on(box, {1, 2, 0}, Vector3::UnitZ()).position - Vector3(1, 2, 0.5)).norm(), 1e-15);
}

TEST(PlaceSolid, ARayMeetsTheNearestSolidFromOutside) {
  Solid box, ball;
  box.id = 4;
  ball.kind = SolidKind::sphere;
  ball.id = 9;
  ball.position = {3, 0, 0};
  const std::vector<Solid> solids{ball, box};
  const auto hit = hit_solids(solids, {-5, 0.1, 0.2}, Vector3::UnitX());
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->solid, 4U);
  EXPECT_NEAR(hit->distance, 4.5, 1e-6);
  EXPECT_LT((hit->normal + Vector3::UnitX()).norm(), 1e-6);
  const auto back = hit_solids(solids, {9, 0, 0}, -Vector3::UnitX());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->solid, 9U);
  EXPECT_LT((back->point - Vector3(3.5, 0, 0)).norm(), 1e-6);
  EXPECT_FALSE(hit_solids(solids, {-5, 2, 0}, Vector3::UnitX()));
  EXPECT_FALSE(hit_solids(solids, {-5, 0, 0}, -Vector3::UnitX()));
}

/// Long runs found edges whose other face gave the normal (HARIKO_SEED=2860399648).
TEST(PlaceSolid, WhatARayMeetsLiesOnTheSolid) {
  for_random(12, 60, [](std::mt19937_64& rng) {
    Solid solid = random_solid(rng);
    if (solid.kind == SolidKind::torus) solid.kind = SolidKind::cone;  // its middle is not inside of it
    solid.position = random_vector(rng);
    solid.rotation = random_vector(rng, 180);
    const SolidShape on(solid, Vector3::Zero());
    const Vector3 from = solid.position + 8 * random_vector(rng).normalized();
    // Just inside: what only grazes the solid may miss it.
    const Vector3 to =
        on.centre() + 0.98 * (on.surface_points(7)[std::size_t(uniform_int(rng, 0, 6))] - on.centre());
    const auto hit = hit_solids(std::vector{solid}, from, (to - from).normalized());
    ASSERT_TRUE(hit);
    EXPECT_LE(hit->distance, (to - from).norm() + 1e-5);
    EXPECT_NEAR(on.distance(hit->point), 0, 1e-5);
    EXPECT_LT(hit->normal.dot(to - from), 1e-3 * (to - from).norm());
  });
}

}  // namespace hariko::test

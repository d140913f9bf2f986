// Solids under transformations: their points move with the space round them.

#include "core/modeling/objects/transform_solid.hpp"

#include <Eigen/Geometry>

#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

Solid random_placed_solid(std::mt19937_64& rng) {
  Solid solid;
  solid.position = random_vector(rng, 3);
  solid.rotation = random_vector(rng, 180);
  solid.scale = {uniform(rng, 0.5, 2), uniform(rng, 0.5, 2), uniform(rng, 0.5, 2)};
  return solid;
}

Vector3 place(const Solid& solid, const Vector3& local) {
  return solid.position + solid_rotation(solid.rotation) * solid.scale.cwiseProduct(local);
}

}  // namespace

TEST(TransformSolid, MovesAndTurnsAreExact) {
  for_random(31, 50, [](std::mt19937_64& rng) {
    const Solid solid = random_placed_solid(rng);
    Transformation t;
    t.translation = random_vector(rng, 2);
    t.axis = random_vector(rng).normalized();
    t.degrees = uniform(rng, -300, 300);
    const double factor = uniform(rng, 0.3, 3);
    t.factors = Vector3::Constant(factor);
    const Vector3 pivot = random_vector(rng, 2);
    const Solid moved = transformed(solid, t, pivot);
    for (int i = 0; i < 4; ++i) {
      const Vector3 local = random_vector(rng);
      EXPECT_LT((place(moved, local) - t.apply(place(solid, local), pivot)).norm(), 1e-9);
    }
  });
}

TEST(TransformSolid, StretchingAlongTheOwnAxesIsExact) {
  for_random(32, 50, [](std::mt19937_64& rng) {
    const Solid solid = random_placed_solid(rng);
    Transformation t;
    t.frame = solid_rotation(solid.rotation);
    t.factors = {uniform(rng, 0.3, 3), uniform(rng, 0.3, 3), uniform(rng, 0.3, 3)};
    const Solid stretched = transformed(solid, t, solid.position);
    const Vector3 local = random_vector(rng);
    EXPECT_LT((place(stretched, local) - t.apply(place(solid, local), solid.position)).norm(), 1e-9);
  });
}

TEST(TransformSolid, ShearLeavesARotationAndPositiveLengths) {
  for_random(33, 50, [](std::mt19937_64& rng) {
    const Solid solid = random_placed_solid(rng);
    Transformation t;
    t.factors = {uniform(rng, -3, -0.3), uniform(rng, 0.3, 3), 1};
    const Solid stretched = transformed(solid, t, Vector3::Zero());
    EXPECT_TRUE(stretched.rotation.allFinite());
    EXPECT_GT(stretched.scale.minCoeff(), 0);
    const Matrix3 axes = t.linear() * solid_rotation(solid.rotation);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(stretched.scale[i], solid.scale[i] * axes.col(i).norm(), 1e-9 * stretched.scale[i]);
  });
}

TEST(TransformSolid, MovingOnlyKeepsTheNumbersOfTheRest) {
  for_random(34, 10, [](std::mt19937_64& rng) {
    const Solid solid = random_placed_solid(rng);
    Transformation t;
    t.translation = random_vector(rng);
    const Solid moved = transformed(solid, t, random_vector(rng));
    EXPECT_EQ(moved.rotation, solid.rotation);
    EXPECT_EQ(moved.scale, solid.scale);
  });
}

}  // namespace hariko::test

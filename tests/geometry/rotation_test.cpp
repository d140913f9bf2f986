#include "core/geometry/rotation.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "tests/support/random.hpp"

namespace hariko::test {

TEST(LeastRotation, TakesOneDirectionToAnotherByTheLeastAngle) {
  for_random(31, 1000, [&](std::mt19937_64& rng) {
    const int kind = uniform_int(rng, 0, 2);
    const Vector3 a = random_vector(rng).normalized();
    Vector3 b = random_vector(rng).normalized();
    // Near the same and near the opposite direction, too.
    if (kind == 1) b = (a + std::exp(uniform(rng, -40, 0)) * b).normalized();
    if (kind == 2) b = (-a + std::exp(uniform(rng, -40, 0)) * b).normalized();
    const double scale = std::exp(uniform(rng, -200, 200));
    const Eigen::Quaterniond q = least_rotation(scale * a, b / scale);
    EXPECT_NEAR(q.norm(), 1, 1e-14);
    EXPECT_LE((q * a - b).norm(), 1e-14);
    const double angle = 2 * std::atan2((a - b).norm(), (a + b).norm());
    EXPECT_NEAR(2 * std::atan2(q.vec().norm(), std::abs(q.w())), angle, 1e-14);
  });
}

TEST(LeastRotation, OppositeDirectionsAreHalfATurnApartAndZeroTurnsNothing) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 a = Vector3::Unit(axis);
    EXPECT_EQ(least_rotation(a, a).angularDistance(Eigen::Quaterniond::Identity()), 0);
    EXPECT_LE((least_rotation(a, -a) * a + a).norm(), 1e-15);
    EXPECT_TRUE(least_rotation(a, Vector3::Zero()).isApprox(Eigen::Quaterniond::Identity()));
  }
}

/// On a circle a step turns the vector about the circle's axis, exactly.
TEST(CarriedAlong, AnArcTurnsAboutItsAxisAndACornerByTheLeastAngle) {
  for_random(32, 300, [&](std::mt19937_64& rng) {
    const Vector3 axis = random_vector(rng).normalized(), from = axis.unitOrthogonal();
    const double angle = uniform(rng, -2, 2), size = std::exp(uniform(rng, -20, 20));
    const Eigen::AngleAxisd turn(angle, axis);
    const Vector3 middle = axis.cross(from) * (angle < 0 ? -size : size);
    const Vector3 chord = middle - turn * middle;
    const Vector3 across = Eigen::AngleAxisd(uniform(rng, 0, 6), from) * axis;
    for (const Vector3& step : {chord, Vector3(Vector3::Zero())})
      EXPECT_LE((carried_along(across, from, turn * from, step) - turn * across).norm(), 1e-12);
  });
}

}  // namespace hariko::test

// The overlap test: against exact arithmetic of another kind, and where doubles alone would not tell.

#include "core/unfolding/cuts/convex_overlap.hpp"

#include <numbers>

#include "tests/support/random.hpp"
#include "tests/unfolding/check_layout.hpp"

namespace hariko::test {
namespace {

Corners counter_clockwise(Corners c) {
  if (exact_cross(c[0], c[1], c[2]).sign() < 0) std::swap(c[1], c[2]);
  return c;
}

Corners random_triangle(std::mt19937_64& rng) {
  const auto point = [&] { return Vector2(uniform(rng, -1, 1), uniform(rng, -1, 1)); };
  return counter_clockwise({point(), point(), point()});
}

TEST(ConvexOverlap, RandomTrianglesAgreeWithExactNumbers) {
  int overlapping = 0, apart = 0;
  for_random(11, 3000, [&](std::mt19937_64& rng) {
    const Corners p = random_triangle(rng), q = random_triangle(rng);
    const double tolerance = chance(rng, 0.5) ? 0 : log_uniform(rng, 1e-12, 0.3);
    const bool wanted = exactly_overlap(p, q, tolerance);
    ++(wanted ? overlapping : apart);
    ASSERT_EQ(overlaps(p, q, tolerance), wanted);
    ASSERT_EQ(overlaps(q, p, tolerance), wanted);
  });
  EXPECT_GT(overlapping, 500);
  EXPECT_GT(apart, 500);
}

TEST(ConvexOverlap, DecidesToTheLastBitAtTheTolerance) {
  // A triangle that dips by a few ulp more or less than the tolerance over a slanted edge.
  int exact_needed = 0;
  for_random(12, 2000, [&](std::mt19937_64& rng) {
    const double angle = uniform(rng, 0, 2 * std::numbers::pi), tolerance = 1e-9;
    const Vector2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
    const Vector2 a = 0.3 * Vector2(uniform(rng), uniform(rng)), b = a + along;
    const double depth = tolerance * (1 + uniform_int(rng, -4, 4) * 1e-8);
    const Corners p = {a, b, a + 0.5 * along + across};
    const Vector2 tip = a + uniform(rng, 0.2, 0.8) * along + depth * across;
    const Corners q = {tip, tip - across - 0.2 * along, tip - across + 0.2 * along};
    const bool wanted = exactly_overlap(p, q, tolerance);
    ASSERT_EQ(overlaps(p, q, tolerance), wanted);
    const double cross = along.x() * (tip.y() - a.y()) - along.y() * (tip.x() - a.x());
    if ((cross > tolerance) != wanted) ++exact_needed;
  });
  EXPECT_GT(exact_needed, 0) << "the cases are too easy for the exact part to matter";
}

TEST(ConvexOverlap, ContainmentAndCoincidenceCountTouchingDoesNot) {
  const Corners big = {Vector2(0, 0), Vector2(4, 0), Vector2(0, 4)};
  const Corners inside = {Vector2(1, 1), Vector2(1.5, 1), Vector2(1, 1.5)};
  const Corners beside = {Vector2(4, 0), Vector2(4, 4), Vector2(0, 4)};
  const Corners corner = {Vector2(-1, -1), Vector2(0, -1), Vector2(0, 0)};
  EXPECT_TRUE(overlaps(big, inside, 0));
  EXPECT_TRUE(overlaps(inside, big, 0));
  EXPECT_TRUE(overlaps(big, big, 1e-9));
  EXPECT_FALSE(overlaps(big, beside, 0));
  EXPECT_FALSE(overlaps(big, corner, 0));
  const std::array<Vector2, 4> quad = {Vector2(1, 1), Vector2(3, 1), Vector2(3, 3), Vector2(1, 3)};
  EXPECT_TRUE(overlaps(quad, big, 0));
  EXPECT_FALSE(overlaps(quad, corner, 0));
}

}  // namespace
}  // namespace hariko::test

// Places where a surface runs below solids, also between the vertices of its triangles.

#include "core/envelope/surface_dips.hpp"

#include <algorithm>

#include "core/envelope/solid.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

constexpr double ball_radius = 0.8;  ///< some cells wide
constexpr int density = 16;

std::vector<PlacedSolid> ball_at(const Vector3& centre) {
  EnvelopeInput input;
  Solid ball;
  ball.kind = SolidKind::sphere;
  ball.radius = ball_radius;
  ball.position = centre;
  input.solids = {ball};
  return place_solids(input);
}

/// The deepest dip below a ball that reaches `out` above the surface at this point, and nowhere else.
void check_ball(const Surface& surface, const Vector3& point, const Vector3& normal, double out) {
  const TriangleMesh mesh = tessellate(surface, density);
  const auto solids = ball_at(point - (ball_radius - out) * normal);
  const auto dips = surface_dips(surface, mesh, density, solids, 1e-6);
  ASSERT_FALSE(dips.empty());
  const auto deepest = std::ranges::max_element(dips, {}, &SurfaceDip::depth);
  EXPECT_NEAR(deepest->depth, out, 0.02 * out + 1e-4);
  EXPECT_LE((deepest->point - point).norm(), 0.02);
  EXPECT_GE(deepest->normal.dot(normal), 0.999);
  EXPECT_EQ(deepest->solid, 0U);
  EXPECT_TRUE(
      surface_dips(surface, mesh, density, ball_at(point - (ball_radius + out) * normal), 1e-6).empty());
}

}  // namespace

TEST(SurfaceDips, AreFoundBetweenTheVerticesOfSquares) {
  const Surface surface = torus(3, 1, 12, 6);
  int unseen = 0;
  for_random(51, 40, [&](std::mt19937_64& rng) {
    const double u = uniform(rng, 0, 2 * std::numbers::pi), v = uniform(rng, 0, 2 * std::numbers::pi);
    const Vector3 across(std::cos(u), std::sin(u), 0);
    const Vector3 normal = std::cos(v) * across + std::sin(v) * Vector3::UnitZ();
    const Vector3 point = 3 * across + normal;
    const double out = log_uniform(rng, 3e-4, 1e-2);
    check_ball(surface, point, normal, out);
    const PlacedSolid ball = ball_at(point - (ball_radius - out) * normal)[0];
    unseen += std::ranges::none_of(tessellate(surface, density).positions,
                                   [&](const Vector3& p) { return ball.depth(p) > 0; });
  });
  // Else the test would show nothing that vertices do not.
  EXPECT_GT(unseen, 0);
}

TEST(SurfaceDips, AreFoundBetweenTheVerticesOfTriangles) {
  const Surface surface = sphere(2);
  for_random(61, 40, [&](std::mt19937_64& rng) {
    const Vector3 normal = random_vector(rng).normalized();
    check_ball(surface, 2 * normal, normal, log_uniform(rng, 3e-4, 1e-2));
  });
}

TEST(SurfaceDips, OfSeveralSolidsAreAllFound) {
  const Surface surface = sphere(2);
  auto solids = ball_at((2 - ball_radius + 0.003) * Vector3(0.6, 0.48, 0.64));
  const auto more = ball_at((2 - ball_radius + 0.001) * Vector3(0.64, 0.6, 0.48));
  solids.insert(solids.end(), more.begin(), more.end());
  const auto dips = surface_dips(surface, tessellate(surface, density), density, solids, 1e-6);
  for (const Index solid : {0U, 1U}) {
    double deepest = 0;
    for (const SurfaceDip& dip : dips)
      if (dip.solid == solid) deepest = std::max(deepest, dip.depth);
    EXPECT_NEAR(deepest, solid == 0 ? 0.003 : 0.001, 1e-4);
  }
}

}  // namespace hariko::test

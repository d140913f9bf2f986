#include "core/surface/patch.hpp"

#include <Eigen/Geometry>
#include <set>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

constexpr Domain domains[] = {Domain::triangle, Domain::square};

TEST(GridFraction, IsSymmetricBitForBit) {
  for (int n = 1; n <= 300; ++n)
    for (int i = 0; i <= n; ++i) {
      const double x = grid_fraction(i, n), y = grid_fraction(n - i, n);
      EXPECT_EQ(1 - x, y);
      EXPECT_EQ(1 - y, x);
      EXPECT_EQ(x + y, 1);
      EXPECT_NEAR(x, double(i) / n, 1.2e-16);
    }
}

TEST(Parameters, SidesRunFromCornerToCorner) {
  for (const Domain domain : domains)
    for (int side = 0; side < corner_count(domain); ++side) {
      const Vector2 begin = corner_parameter(domain, side);
      const Vector2 end = corner_parameter(domain, (side + 1) % corner_count(domain));
      EXPECT_EQ(side_parameter(domain, side, 0), begin);
      EXPECT_EQ(side_parameter(domain, side, 1), end);
      EXPECT_TRUE(side_parameter(domain, side, 0.25).isApprox(0.75 * begin + 0.25 * end, 1e-15));
    }
}

TEST(GridPattern, NumbersPointsInOrder) {
  for (const Domain domain : domains)
    for (const int n : {1, 2, 3, 7, 8}) {
      const GridPattern pattern{domain, n};
      const auto parameters = pattern.parameters();
      ASSERT_EQ(parameters.size(), static_cast<std::size_t>(pattern.point_count()));
      int expected = 0;
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= (domain == Domain::triangle ? n - j : n); ++i) {
          ASSERT_EQ(pattern.index(i, j), expected);
          EXPECT_EQ(parameters[static_cast<std::size_t>(expected)],
                    Vector2(grid_fraction(i, n), grid_fraction(j, n)));
          ++expected;
        }
    }
}

TEST(GridPattern, SidesAreTheParametersOfTheSide) {
  for (const Domain domain : domains)
    for (const int n : {1, 2, 5, 8, 49}) {
      const GridPattern pattern{domain, n};
      const auto parameters = pattern.parameters();
      for (int side = 0; side < corner_count(domain); ++side) {
        const auto points = pattern.side(side);
        ASSERT_EQ(points.size(), static_cast<std::size_t>(n) + 1);
        for (int k = 0; k <= n; ++k)
          EXPECT_EQ(parameters[static_cast<std::size_t>(points[static_cast<std::size_t>(k)])],
                    side_parameter(domain, side, grid_fraction(k, n)));
      }
    }
}

TEST(GridPattern, TrianglesCoverTheDomainOnce) {
  for (const Domain domain : domains)
    for (const int n : {1, 2, 5, 8}) {
      const GridPattern pattern{domain, n};
      const auto parameters = pattern.parameters();
      const auto triangles = pattern.triangles();
      EXPECT_EQ(triangles.size(), static_cast<std::size_t>(domain == Domain::triangle ? n * n : 2 * n * n));
      double area = 0;
      std::set<std::pair<int, int>> edges;
      for (const auto& t : triangles) {
        const Vector2 a = parameters[std::size_t(t[0])];
        const Vector2 b = parameters[std::size_t(t[1])] - a, c = parameters[std::size_t(t[2])] - a;
        const double own = (b.x() * c.y() - b.y() * c.x()) / 2;
        EXPECT_GT(own, 0.4 / (n * n));
        area += own;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.insert({t[k], t[(k + 1) % 3]}).second);
      }
      EXPECT_NEAR(area, domain == Domain::triangle ? 0.5 : 1.0, 1e-14);
    }
}

TEST(UnitNormal, IsUnitAndOrthogonalAtAnyScale) {
  test::for_random(11, 200, [](std::mt19937_64& rng) {
    PatchPoint p;
    const double scale = test::log_uniform(rng, 1e-150, 1e150);
    p.ds = scale * test::random_vector(rng);
    p.dt = test::random_vector(rng) / scale;
    const Vector3 n = unit_normal(p);
    EXPECT_NEAR(n.norm(), 1, 1e-14);
    EXPECT_NEAR(n.dot(p.ds / scale), 0, 1e-12);
    EXPECT_NEAR(n.dot(p.dt * scale), 0, 1e-12);
    EXPECT_GT((p.ds / scale).cross(p.dt * scale).dot(n), 0);
  });
}

TEST(UnitNormal, IsZeroWhereTheDerivativesAreParallel) {
  PatchPoint p;
  EXPECT_TRUE(unit_normal(p).isZero(0));
  p.ds = {1, 2, 3};
  EXPECT_TRUE(unit_normal(p).isZero(0));
  p.dt = {-2, -4, -6};
  EXPECT_TRUE(unit_normal(p).isZero(0));
  p.dt = {-2, -4, -6 + 1e-13};
  EXPECT_TRUE(unit_normal(p).isZero(0));
  p.dt = {-2, -4, -6 + 1e-10};
  EXPECT_FALSE(unit_normal(p).isZero(0));
}

}  // namespace
}  // namespace hariko

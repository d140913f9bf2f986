#include "core/analysis/measures.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/parallel.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Measures, OfASphere) {
  const Measures m = measure(test::sphere(3));
  EXPECT_NEAR(m.area, 36 * pi, 36 * pi * 1e-7);
  ASSERT_TRUE(m.volume);
  EXPECT_NEAR(*m.volume, 36 * pi, 36 * pi * 1e-7);
  EXPECT_NEAR(m.bending, 8 * pi, 8 * pi * 1e-7);
}

TEST(Measures, OfATorus) {
  const double large = 2, small = 1;
  const Measures m = measure(test::torus(large, small, 6, 5));
  EXPECT_NEAR(m.area, 4 * pi * pi * large * small, 1e-9);
  ASSERT_TRUE(m.volume);
  EXPECT_NEAR(*m.volume, 2 * pi * pi * large * small * small, 1e-9);
  // Willmore: integral of mean^2 is pi^2 R^2 / (r sqrt(R^2 - r^2)), that of Gauss is 0; k1^2 + k2^2 = 4
  // mean^2 - 2 gauss.
  EXPECT_NEAR(m.bending, 4 * pi * pi * large * large / (small * std::sqrt(large * large - small * small)),
              1e-8);
}

TEST(Measures, OfAnOpenSaddle) {
  const Measures m = measure(test::height_field(2, 2, [](Index, Index) { return test::saddle(); }));
  EXPECT_FALSE(m.volume);
  // Simpson's rule over a fine grid as an independent reference for the integral of sqrt(1 + x^2 + y^2).
  const int n = 200;
  double area = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const auto weight = [&](int k) { return (k == 0 || k == n ? 1.0 : k % 2 ? 4.0 : 2.0) * (2.0 / n) / 3; };
      const double x = 2.0 * i / n, y = 2.0 * j / n;
      area += weight(i) * weight(j) * std::sqrt(1 + x * x + y * y);
    }
  EXPECT_NEAR(m.area, area, 1e-8);
}

TEST(Measures, DoNotDependOnTheOriginOrTheThreads) {
  test::AnalyticOptions far;
  far.origin = {1e6, 1e6, -1e6};
  const Measures a = measure(test::sphere(1)), b = measure(test::sphere(1, far));
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.bending, b.bending);
  const ParallelLimit one(1);
  const Measures c = measure(test::sphere(1));
  EXPECT_EQ(a.area, c.area);
  EXPECT_EQ(a.bending, c.bending);
}

TEST(Measures, OfNothingAndWhenCancelled) {
  EXPECT_EQ(measure(Surface()).area, 0);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(measure(test::sphere(1), cancel).area, 0);
}

}  // namespace
}  // namespace hariko

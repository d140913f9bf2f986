#include "core/cad/spline.hpp"

#include <gtest/gtest.h>

#include "core/cad/spline_fit.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

SplineSpace random_space(std::mt19937_64& rng) {
  SplineSpace out{uniform_int(rng, 1, 7), {0}};
  const int spans = uniform_int(rng, 1, 9);
  for (int i = 0; i < spans; ++i) out.breaks.push_back(out.breaks.back() + uniform(rng, 0.25, 1));
  return out;
}

Vector3 random_point(std::mt19937_64& rng) {
  return {uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)};
}

TEST(Spline, FunctionsAddUpToOneAndTheirDerivativesToNothing) {
  for_random(4100, 40, [](std::mt19937_64& rng) {
    const SplineSpace space = random_space(rng);
    for (int k = 0; k < 20; ++k) {
      const double x = k == 0 ? space.begin() : k == 1 ? space.end() : uniform(rng, 0, space.end());
      const SplineBasis basis = spline_basis(space, space.knots(), x);
      double sum = 0, rate = 0;
      for (int i = 0; i <= space.degree; ++i) {
        EXPECT_GE(basis.value[std::size_t(i)], -1e-15);
        sum += basis.value[std::size_t(i)];
        rate += basis.derivative[std::size_t(i)];
      }
      EXPECT_NEAR(sum, 1, 1e-14);
      EXPECT_NEAR(rate, 0, 1e-11);
    }
  });
}

TEST(Spline, DerivativesAreThoseOfDifferences) {
  for_random(4200, 20, [](std::mt19937_64& rng) {
    SplineCurve curve{random_space(rng), {}};
    for (std::size_t i = 0; i < curve.space.size(); ++i) curve.points.push_back(random_point(rng));
    for (std::size_t i = 0; i < curve.space.span_count(); ++i) {
      const double x = 0.5 * (curve.space.breaks[i] + curve.space.breaks[i + 1]), h = 1e-5;
      const Vector3 by_difference =
          (evaluate(curve, x + h).position - evaluate(curve, x - h).position) / (2 * h);
      EXPECT_LT((by_difference - evaluate(curve, x).derivative).norm(), 1e-6);
    }
  });
}

TEST(Spline, InterpolationGivesSplinesOfTheSpaceBack) {
  for_random(4300, 40, [](std::mt19937_64& rng) {
    SplineCurve curve{random_space(rng), {}};
    for (std::size_t i = 0; i < curve.space.size(); ++i) curve.points.push_back(random_point(rng));
    SplineSpace finer = curve.space;  // which holds it as well
    finer.breaks.insert(finer.breaks.begin() + 1, 0.5 * finer.breaks[1]);
    const SplineCurve same = in_space(curve, finer);
    ASSERT_EQ(same.points.size(), curve.points.size() + 1);
    EXPECT_EQ(same.points.front(), curve.points.front());
    EXPECT_EQ(same.points.back(), curve.points.back());
    for (int k = 0; k <= 50; ++k) {
      const double x = curve.space.end() * k / 50;
      EXPECT_LT((evaluate(same, x).position - evaluate(curve, x).position).norm(), 1e-12);
      EXPECT_LT(
          (evaluate(reversed(curve), curve.space.end() - x).position - evaluate(curve, x).position).norm(),
          1e-12);
    }
  });
}

TEST(Spline, FitsHalveKnotsWhereTheCurveIsNotSmooth) {
  // |x - 1/3|^1.5: the first derivative is continuous, the second is not finite.
  const auto kink = [](double x) {
    const double d = x - 1.0 / 3, root = std::sqrt(std::abs(d));
    return SplinePoint{{x, std::abs(d) * root, 0}, {1, (d < 0 ? -1.5 : 1.5) * root, 0}};
  };
  const FittedCurve fitted = fit_curve({5, {0, 1}}, kink, {1e-4, 1, 64});
  ASSERT_TRUE(fitted.reached);
  double narrowest = 1, widest = 0;
  for (std::size_t i = 0; i < fitted.curve.space.span_count(); ++i) {
    const double width = fitted.curve.space.breaks[i + 1] - fitted.curve.space.breaks[i];
    narrowest = std::min(narrowest, width);
    widest = std::max(widest, width);
  }
  EXPECT_GT(widest, 16 * narrowest);
  for (int k = 0; k <= 1000; ++k)
    EXPECT_LT((evaluate(fitted.curve, k / 1000.0).position - kink(k / 1000.0).position).norm(), 2e-4);
}

}  // namespace
}  // namespace hariko::test

#include "core/cad/fit/spline.hpp"

#include <cmath>
#include <numbers>

#include "core/cad/fit/curve_fit.hpp"
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

TEST(Spline, GridsArePointsOneByOne) {
  for_random(4270, 10, [](std::mt19937_64& rng) {
    SplineSurface surface{random_space(rng), random_space(rng), {}};
    for (std::size_t i = 0; i < surface.s.size() * surface.t.size(); ++i)
      surface.points.push_back(random_point(rng));
    const std::vector<double> s{surface.s.begin(), uniform(rng, 0, surface.s.end()), surface.s.end()},
        t{surface.t.begin(), uniform(rng, 0, surface.t.end()), surface.t.breaks[1], surface.t.end()};
    const auto grid = evaluate_grid(surface, spline_bases(surface.s, s), spline_bases(surface.t, t));
    const SplineEvaluator one(surface);
    for (std::size_t j = 0; j < t.size(); ++j)
      for (std::size_t i = 0; i < s.size(); ++i) {
        const PatchPoint want = one.at(s[i], t[j]), &got = grid[j * s.size() + i];
        EXPECT_LT((got.position - want.position).norm(), 1e-13);
        EXPECT_LT((got.ds - want.ds).norm(), 1e-11);
        EXPECT_LT((got.dt - want.dt).norm(), 1e-11);
      }
  });
}

TEST(Spline, SecondDerivativesAreThoseOfDifferences) {
  for_random(4250, 20, [](std::mt19937_64& rng) {
    const SplineSpace space = random_space(rng);
    const std::vector<double> knots = space.knots();
    for (std::size_t span = 0; span < space.span_count(); ++span) {
      const double x = 0.5 * (space.breaks[span] + space.breaks[span + 1]), h = 1e-5;
      const SplineBasis low = spline_basis(space, knots, x - h), here = spline_basis(space, knots, x),
                        high = spline_basis(space, knots, x + h);
      for (std::size_t r = 0; r <= std::size_t(space.degree); ++r)
        EXPECT_NEAR(here.second[r], (high.derivative[r] - low.derivative[r]) / (2 * h), 1e-4);
    }
  });
}

TEST(Spline, PlacesOfSpansIntegratePolynomials) {
  for (int count = 1; count <= 16; ++count) {
    const SpanPlaces& places = span_places(count);
    for (int degree = 0; degree < 2 * count; ++degree) {
      double sum = 0;
      for (std::size_t i = 0; i < places.at.size(); ++i)
        sum += places.weight[i] * std::pow(places.at[i], degree);
      EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14) << count << " places, degree " << degree;
    }
  }
}

TEST(Spline, CurvesAreFittedByOneSpanWhereItIsEnough) {
  // A quarter of a circle of radius 10: a cubic span with the directions in its ends is within 3e-4 of the
  // radius.
  const auto circle = [](double x) {
    const double turn = 0.5 * std::numbers::pi * x;
    return TracedPoint{10 * Vector3(std::cos(turn), std::sin(turn), 0),
                       5 * std::numbers::pi * Vector3(-std::sin(turn), std::cos(turn), 0), Vector3::Zero()};
  };
  const auto off = [](const SplineCurve& curve) {
    double out = 0;
    for (int k = 0; k <= 200; ++k)
      out = std::max(out, std::abs(evaluate(curve, k / 200.0).position.norm() - 10));
    return out;
  };
  const FittedCurve rough = fit_curve({3, {0, 1}}, circle, {0.02, 1, 1}),
                    fine = fit_curve({3, {0, 1}}, circle, {1e-5, 1, 1});
  EXPECT_LE(rough.curve.points.size(), 5U);
  EXPECT_TRUE(rough.reached && fine.reached);
  EXPECT_LE(off(rough.curve), 0.02);
  EXPECT_LE(off(fine.curve), 1e-5);
  EXPECT_GT(fine.curve.points.size(), rough.curve.points.size());
  for (const FittedCurve* fitted : {&rough, &fine}) {
    EXPECT_EQ(fitted->curve.points.front(), circle(0).position);
    EXPECT_EQ(fitted->curve.points.back(), circle(1).position);
    EXPECT_LT(evaluate(fitted->curve, 0).derivative.normalized().cross(Vector3(0, 1, 0)).norm(), 1e-12);
  }
}

TEST(Spline, InterpolationGivesSplinesOfTheSpaceBack) {
  for_random(4300, 40, [](std::mt19937_64& rng) {
    SplineCurve curve{random_space(rng), {}};
    for (std::size_t i = 0; i < curve.space.size(); ++i) curve.points.push_back(random_point(rng));
    SplineSpace finer = curve.space;  // a finer space holds the curve as well
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
    return TracedPoint{{x, std::abs(d) * root, 0}, {1, (d < 0 ? -1.5 : 1.5) * root, 0}, Vector3::Zero()};
  };
  const FittedCurve fitted = fit_curve({5, {0, 1}}, kink, {1e-4, 1, 1});
  ASSERT_TRUE(fitted.reached);
  double narrowest = 1, widest = 0;
  for (std::size_t i = 0; i < fitted.curve.space.span_count(); ++i) {
    const double width = fitted.curve.space.breaks[i + 1] - fitted.curve.space.breaks[i];
    narrowest = std::min(narrowest, width);
    widest = std::max(widest, width);
  }
  EXPECT_GT(widest, 8 * narrowest);
  for (int k = 0; k <= 1000; ++k)
    EXPECT_LT((evaluate(fitted.curve, k / 1000.0).position - kink(k / 1000.0).position).norm(), 2e-4);
}

}  // namespace
}  // namespace hariko::test

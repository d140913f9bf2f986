#include "core/subdivision/subdivision_curve.hpp"

#include <numbers>

#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;

SubdivisionCurve random_curve(std::mt19937_64& rng, double corners = 0.2) {
  SubdivisionCurve curve;
  curve.closed = chance(rng, 0.4);
  const int n = uniform_int(rng, curve.closed ? 3 : 2, 9);
  for (int i = 0; i < n; ++i) {
    curve.points.push_back(random_vector(rng));
    curve.sharp.push_back(chance(rng, corners));
  }
  return curve;
}

/// Subdivided so often that points and parameters are those of the curve to rounding of 4^-levels.
SubdivisionCurve deep(SubdivisionCurve curve, int levels) {
  for (int i = 0; i < levels; ++i) curve = refined(curve);
  return curve;
}

TEST(SubdivisionCurve, FormulaIsTheLimitOfRefinement) {
  for_random(81, 40, [](std::mt19937_64& rng) {
    const SubdivisionCurve curve = random_curve(rng);
    const SubdivisionCurve fine = deep(curve, 4);
    const std::vector<Vector3> limits = limit_points(fine);
    for (int i = 0; i < fine.size(); ++i)
      ASSERT_LT((evaluate(curve, fine.parameter(i)).position - limits[std::size_t(i)]).norm(), 1e-13);
  });
}

TEST(SubdivisionCurve, DerivativesAreThoseOfThePosition) {
  for_random(82, 40, [](std::mt19937_64& rng) {
    const SubdivisionCurve curve = random_curve(rng);
    // Inside a span; third derivatives are bounded by spans^3.
    const int n = curve.spans();
    const double u = (uniform_int(rng, 0, n - 1) + uniform(rng, 0.1, 0.9)) / n, h = 1e-4 / n;
    const CurvePoint at = evaluate(curve, u), a = evaluate(curve, u - h), b = evaluate(curve, u + h);
    EXPECT_LT(((b.position - a.position) / (2 * h) - at.first).norm(), 1e-6 * n);
    EXPECT_LT(((b.first - a.first) / (2 * h) - at.second).norm(), 1e-6 * n * n);
  });
}

TEST(SubdivisionCurve, CurveThroughPointsHasThemAsLimits) {
  for_random(83, 100, [](std::mt19937_64& rng) {
    const SubdivisionCurve drawn = random_curve(rng);
    const SubdivisionCurve curve = curve_through(drawn.points, drawn.closed, drawn.sharp);
    const std::vector<Vector3> limits = limit_points(curve);
    for (std::size_t i = 0; i < limits.size(); ++i) ASSERT_LT((limits[i] - drawn.points[i]).norm(), 1e-13);
  });
}

TEST(SubdivisionCurve, RefinementKeepsTheCurve) {
  for_random(84, 40, [](std::mt19937_64& rng) {
    const SubdivisionCurve curve = random_curve(rng), fine = refined(curve);
    EXPECT_EQ(fine.size(), curve.closed ? 2 * curve.size() : 2 * curve.size() - 1);
    for (int i = 0; i <= 50; ++i)
      ASSERT_LT((evaluate(curve, i / 50.0).position - evaluate(fine, i / 50.0).position).norm(), 1e-13);
  });
}

TEST(SubdivisionCurve, InsertedAndDeletedPointsKeepTheOtherLimits) {
  for_random(85, 40, [](std::mt19937_64& rng) {
    const SubdivisionCurve curve = random_curve(rng, 0);
    const std::vector<Vector3> before = limit_points(curve);
    const int span = uniform_int(rng, 0, curve.spans() - 1);
    const Reshaped more = with_point_inserted(curve, span);
    ASSERT_EQ(more.curve.size(), curve.size() + 1);
    std::vector<Vector3> after = limit_points(more.curve);
    after.erase(after.begin() + span + 1);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT((after[i] - before[i]).norm(), 1e-12);
    EXPECT_TRUE(std::isfinite(more.deviation));
    const Reshaped fewer = with_point_deleted(more.curve, span + 1);
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_LT((fewer.curve.points[i] - curve.points[i]).norm(), 1e-11);
  });
  // A curve with little shape barely notices one more point.
  SubdivisionCurve ring;
  ring.closed = true;
  for (int i = 0; i < 12; ++i)
    ring.points.push_back({std::cos(i * std::numbers::pi / 6), std::sin(i * std::numbers::pi / 6), 0});
  const double one = with_point_inserted(ring, 3).deviation;
  EXPECT_GT(one, 0);
  EXPECT_LT(one, 2e-2);
}

TEST(SubdivisionCurve, NearestPointIsNearerThanSamples) {
  for_random(87, 60, [](std::mt19937_64& rng) {
    const SubdivisionCurve curve = random_curve(rng);
    const Vector3 target = random_vector(rng, 1.5);
    const CurveFoot foot = nearest_point(curve, target);
    EXPECT_NEAR((evaluate(curve, foot.parameter).position - target).norm(), foot.distance, 1e-12);
    for (int i = 0; i <= 200; ++i)
      ASSERT_GT((evaluate(curve, i / 200.0).position - target).norm(), foot.distance - 2e-3);
  });
}

}  // namespace
}  // namespace hariko

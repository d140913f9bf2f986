#include "core/skinning/edit/freehand_curve.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

/// Points of a curve as a hand draws them: at uneven distances, trembling by up to `tremor`.
std::vector<Vector3> drawn(std::mt19937_64& rng, const SubdivisionCurve& curve, double tremor) {
  std::vector<Vector3> out;
  for (double u = 0; u < 1; u += uniform(rng, 0.001, 0.006))
    out.push_back(evaluate(curve, u).position + random_vector(rng, tremor));
  if (!curve.closed) out.push_back(evaluate(curve, 1).position);
  return out;
}

TEST(FreehandCurve, FollowsSmoothStrokesWithFewPoints) {
  for_random(921, 30, [](std::mt19937_64& rng) {
    SubdivisionCurve curve;
    curve.closed = chance(rng, 0.5);
    const int n = uniform_int(rng, 5, 8);
    for (int i = 0; i < n; ++i) {
      const double a = (curve.closed ? 2 : 1) * std::numbers::pi * i / n;
      curve.points.push_back(Vector3(100 * std::cos(a), 100 * std::sin(a), 0) +
                             Vector3(uniform(rng, -15, 15), uniform(rng, -15, 15), 0));
    }
    const double tolerance = 2;
    const std::vector<Vector3> line = drawn(rng, curve, 0.4);
    const auto fit = must(freehand_curve(line, curve.closed, tolerance));
    EXPECT_EQ(fit->closed, curve.closed);
    EXPECT_LE(fit->size(), 24) << "for a curve of " << n;
    EXPECT_TRUE(fit->sharp.empty()) << "a corner where there is none";
    for (const Vector3& p : line) EXPECT_LT(nearest_point(*fit, p).distance, 1.5 * tolerance);
    for (int i = 0; i <= 200; ++i) {
      const Vector3 p = evaluate(*fit, i / 200.0).position;
      EXPECT_LT(nearest_point(curve, p).distance, 1.5 * tolerance);
    }
    if (!curve.closed) {
      EXPECT_LT((fit->points.front() - line.front()).norm(), 1e-12);
      EXPECT_LT((fit->points.back() - line.back()).norm(), 1e-12);
    }
  });
}

TEST(FreehandCurve, CornersAreKept) {
  for_random(922, 12, [](std::mt19937_64& rng) {
    const bool closed = chance(rng, 0.5);
    const std::vector<Vector3> corners{
        {0, 0, 0}, {200, uniform(rng, -20, 20), 0}, {190, 150, 0}, {0, 160, 0}};
    std::vector<Vector3> line;
    for (std::size_t i = 0; i < (closed ? 4U : 3U); ++i)
      for (int k = 0; k < 50; ++k)
        line.push_back(corners[i] + (corners[(i + 1) % 4] - corners[i]) * (k / 50.0) +
                       random_vector(rng, 0.3));
    if (!closed) line.push_back(corners[3]);
    const auto fit = must(freehand_curve(line, closed, 2));
    int sharp = 0;
    for (int i = 0; i < fit->size(); ++i) {
      if (!fit->is_sharp(i)) continue;
      ++sharp;
      double nearest = 1e9;
      for (const Vector3& corner : corners)
        nearest = std::min(nearest, (corner - fit->points[std::size_t(i)]).norm());
      EXPECT_LT(nearest, 6);
    }
    // The beginning of a closed stroke may be a corner, too; the ends of an open one are none.
    EXPECT_GE(sharp, closed ? 3 : 2);
    EXPECT_LE(sharp, closed ? 4 : 2);
    for (const Vector3& p : line) EXPECT_LT(nearest_point(*fit, p).distance, 5);
  });
}

TEST(FreehandCurve, AShortStrokeIsRefused) {
  EXPECT_EQ(freehand_curve({}, false, 1).error().code, e_short_stroke);
  EXPECT_EQ(freehand_curve({Vector3::Zero()}, true, 1).error().code, e_short_stroke);
  EXPECT_EQ(freehand_curve({Vector3::Zero(), Vector3(3, 0, 0)}, false, 1).error().code, e_short_stroke);
  EXPECT_EQ(freehand_curve({Vector3::Zero(), Vector3::Zero()}, false, 1).error().code, e_short_stroke);
  EXPECT_TRUE(freehand_curve({Vector3::Zero(), Vector3(30, 0, 0)}, false, 1).ok());
}

}  // namespace
}  // namespace hariko::test

#include "core/analysis/continuity.hpp"

#include <gtest/gtest.h>

#include "core/base/parallel.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

TEST(Continuity, SmoothSurfacesHaveNoJumps) {
  for (const Surface& surface : {test::sphere(2), test::torus(2, 1, 5, 4)}) {
    const ContinuityReport report = continuity(surface);
    EXPECT_LT(report.largest_gap, 1e-14);
    ASSERT_TRUE(report.largest_normal_jump);
    EXPECT_LT(*report.largest_normal_jump, 1e-14);
    ASSERT_TRUE(report.rms_curvature_jump);
    EXPECT_LT(*report.rms_curvature_jump, 1e-13);
    EXPECT_EQ(report.degenerate_samples, 0U);
    EXPECT_EQ(report.folded_samples, 0U);
    EXPECT_EQ(report.seams.size(), surface.seams().size());
  }
}

test::Height roof_side(Index i, double angle) {
  const double slope = std::tan(angle / 2);
  return i == 0 ? test::plane(slope) : test::plane(-slope, 0, 2 * slope);
}

TEST(Continuity, AngleOfAKinkIsMeasuredAtAnySize) {
  for (const double angle : {1e-12, 1e-9, 1e-3, 0.5, 2.0, 3.0}) {
    const auto report =
        continuity(test::height_field(2, 1, [&](Index i, Index) { return roof_side(i, angle); }));
    ASSERT_TRUE(report.largest_normal_jump);
    EXPECT_NEAR(*report.largest_normal_jump, angle, 1e-15 + 1e-12 * angle);
    EXPECT_EQ(report.rms_curvature_jump, 0.0) << "flat on both sides";
    EXPECT_EQ(report.folded_samples, 0U);
  }
}

TEST(Continuity, CreasesAreMeasuredButNotCounted) {
  test::AnalyticOptions options;
  options.continuity = Continuity::g0;
  const auto report = continuity(test::height_field(
      2, 1, [](Index i, Index) { return roof_side(i, 0.5); }, options));
  EXPECT_FALSE(report.largest_normal_jump);
  EXPECT_FALSE(report.rms_curvature_jump);
  ASSERT_EQ(report.seams.size(), 1U);
  EXPECT_NEAR(report.seams[0].normal_jump, 0.5, 1e-13);
}

TEST(Continuity, GapIsTheLargestDistance) {
  const auto report = continuity(test::height_field(
      2, 1, [](Index i, Index) { return i == 0 ? test::plane() : test::plane(0, 0.25, 0.125); }));
  EXPECT_NEAR(report.largest_gap, 0.375, 1e-15);
}

TEST(Continuity, CurvatureJumpIsRelative) {
  // A plane meets a trough of radius 2 at its lowest line: tensor norms 0 and 1/2, difference 1/2, mean 1/4.
  const auto report = continuity(test::height_field(2, 1, [](Index i, Index) -> test::Height {
    if (i == 0) return test::plane();
    return [](double x, double y) { return test::trough(2)(x - 1, y); };
  }));
  ASSERT_TRUE(report.rms_curvature_jump);
  EXPECT_NEAR(*report.rms_curvature_jump, 2, 1e-13);
  EXPECT_NEAR(report.seams[0].curvature_jump, 0.5, 1e-14);
  EXPECT_NEAR(report.seams[0].curvature, 0.25, 1e-14);
  EXPECT_EQ(report.seams[0].curvature_samples, 21);
  EXPECT_LT(*report.largest_normal_jump, 1e-15);
}

TEST(Continuity, FoldsAreCountedApart) {
  // The second square lies back over the first one: the same plane, opposite normals.
  const Surface folded = test::make_surface(
      Domain::square,
      {test::height_patch(test::plane(), 0, 0, 1, 1), test::height_patch(test::plane(), 1, 0, -1, 1)},
      {0, 1, 2, 3, 1, 4, 5, 2});
  const auto report = continuity(folded);
  EXPECT_EQ(report.folded_samples, 33U);
  EXPECT_EQ(report.largest_normal_jump, 0.0);
  EXPECT_EQ(report.degenerate_samples, 0U);
}

/// Squares (0 .. 1) and (1 .. 2) by 1 whose common side has no normal: x runs like (1 - s)^2 towards it.
Surface pinched_pair(const std::vector<Vector3>& node_normals) {
  const auto left = [](double s, double t) {
    PatchPoint p;
    p.position = {1 - (1 - s) * (1 - s), t, 0};
    p.ds = {2 * (1 - s), 0, 0};
    p.dt = {0, 1, 0};
    p.dss = {-2, 0, 0};
    return p;
  };
  test::AnalyticOptions options;
  options.node_normals = node_normals;
  return test::make_surface(Domain::square, {left, test::height_patch(test::plane(), 1, 0, 1, 1)},
                            {0, 1, 2, 3, 1, 4, 5, 2}, options);
}

TEST(Continuity, DegeneratePointsAreCountedAndSkipped) {
  const auto report = continuity(pinched_pair(std::vector<Vector3>(6, Vector3::Zero())));
  EXPECT_EQ(report.degenerate_samples, 33U);
  EXPECT_EQ(report.largest_normal_jump, 0.0);
  EXPECT_EQ(report.seams[0].curvature_samples, 0);
}

TEST(Continuity, EndsUseTheNormalOfTheNode) {
  std::vector<Vector3> normals(6, Vector3::Zero());
  normals[1] = Vector3::UnitZ();
  EXPECT_EQ(continuity(pinched_pair(normals)).degenerate_samples, 32U);
  // A node normal that does not fit shows, even though the two sides agree with each other.
  normals.assign(6, Vector3::Zero());
  normals[2] = Vector3(std::sin(0.1), 0, std::cos(0.1));
  test::AnalyticOptions options;
  options.node_normals = normals;
  const auto report = continuity(test::height_field(
      2, 1, [](Index, Index) { return test::plane(); }, options));
  EXPECT_EQ(report.largest_normal_jump, 0.0) << "node 2 is not an end of the seam";
  options.node_normals[1] = normals[2];
  EXPECT_NEAR(*continuity(test::height_field(
                              2, 1, [](Index, Index) { return test::plane(); }, options))
                   .largest_normal_jump,
              0.1, 1e-14);
}

TEST(Continuity, IsTheSameOnAnyNumberOfThreads) {
  const Surface surface = test::torus(2, 0.9, 9, 7);
  const auto many = continuity(surface);
  const ParallelLimit one(1);
  const auto single = continuity(surface);
  EXPECT_EQ(many.largest_gap, single.largest_gap);
  EXPECT_EQ(many.rms_curvature_jump, single.rms_curvature_jump);
}

}  // namespace
}  // namespace hariko

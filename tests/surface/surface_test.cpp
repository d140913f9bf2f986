#include "core/surface/surface.hpp"

#include <gtest/gtest.h>

#include "core/surface/adjacency.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

TEST(Surface, NormalOfASphereIsItsDirection) {
  const Surface surface = test::sphere(2);
  for (Index p = 0; p < surface.patch_count(); ++p)
    for (const Vector2& q : GridPattern{Domain::triangle, 5}.parameters()) {
      const Vector3 position = surface.patches().evaluate(p, q, Order::first).position;
      EXPECT_TRUE(surface.normal(p, q).isApprox(position / 2, 1e-14));
    }
}

/// A triangle whose derivatives at corner 0 are both along x: (s + t^2 .., ..) has no normal of its own
/// there.
PatchPoint pinched(double s, double t) {
  PatchPoint p;
  const double x = s + t;
  p.position = {x, x * (t - s), 0};
  p.ds = {1, (t - s) - x, 0};
  p.dt = {1, (t - s) + x, 0};
  return p;
}

TEST(Surface, DegenerateCornerTakesTheNormalOfTheNodeOrFromInside) {
  test::AnalyticOptions options;
  options.node_normals = {Vector3(0, 0.6, 0.8), Vector3::Zero(), Vector3::Zero()};
  const Surface with = test::make_surface(Domain::triangle, {pinched}, {0, 1, 2}, options);
  EXPECT_EQ(with.normal(0, {0, 0}), Vector3(0, 0.6, 0.8));
  const Surface without = test::make_surface(Domain::triangle, {pinched}, {0, 1, 2});
  EXPECT_TRUE(without.normal(0, {0, 0}).isApprox(Vector3::UnitZ(), 1e-12));
  EXPECT_TRUE(without.normal(0, {0.3, 0.3}).isApprox(Vector3::UnitZ(), 1e-12));
}

TEST(Surface, PatchShrunkToAPointHasNoNormal) {
  const Surface surface =
      test::make_surface(Domain::triangle, {[](double, double) { return PatchPoint{}; }}, {0, 1, 2});
  EXPECT_EQ(surface.patch_scale(0), 0);
  EXPECT_TRUE(surface.normal(0, {0, 0}).isZero(0));
  EXPECT_TRUE(surface.normal(0, {0.2, 0.2}).isZero(0));
}

TEST(Surface, WithPatchesKeepsTheAdjacency) {
  const Surface a = test::sphere(1), b = test::sphere(3);
  auto normals = std::make_shared<const std::vector<Vector3>>(6, Vector3::Zero());
  const Surface c =
      a.with_patches(std::shared_ptr<const PatchSet>(
                         std::shared_ptr<const Surface>(std::make_shared<Surface>(b)), &b.patches()),
                     normals);
  EXPECT_TRUE(c.same_adjacency(a));
  EXPECT_FALSE(c.same_adjacency(b));
  EXPECT_NEAR(c.patches().evaluate(0, {0.2, 0.3}, Order::first).position.norm(), 3, 1e-14);
}

TEST(SurfaceDeathTest, RefusesPartsThatDoNotFit) {
  const auto formula = test::height_patch(test::plane(), 0, 0, 1, 1);
  test::AnalyticOptions options;
  options.node_normals = {Vector3::Zero()};
  EXPECT_DEATH(test::make_surface(Domain::square, {formula}, {0, 1, 2, 3}, options), "one normal a node");
  EXPECT_DEATH(test::make_surface(Domain::square, {formula, formula}, {0, 1, 2, 3, 4}), "");
  EXPECT_DEATH(Surface(Surface::Parts{}), "every part");
}

TEST(Adjacency, ClosedAndOpenSurfaces) {
  EXPECT_TRUE(Adjacency(test::sphere(1)).closed());
  EXPECT_TRUE(Adjacency(test::torus(2, 1, 5, 4)).closed());
  const Surface field = test::height_field(3, 2, [](Index, Index) { return test::saddle(); });
  const Adjacency open(field);
  EXPECT_EQ(open.boundary().size(), 10U);
  EXPECT_EQ(open.full_seam({0, 0}), no_index);
  const Index seam = open.full_seam({0, 1});
  ASSERT_NE(seam, no_index);
  EXPECT_EQ(open.full_seam({1, 3}), seam);
  ASSERT_EQ(open.seams({1, 3}).size(), 1U);
  EXPECT_EQ(open.seams({1, 3})[0], seam);
  EXPECT_TRUE(open.seams({0, 0}).empty());
  EXPECT_TRUE(Adjacency(Surface()).closed());
}

TEST(Adjacency, SideWithTwoSeamsIsCoveredButHasNoFullSeam) {
  // One wide square below two narrow ones.
  const Surface pieces = test::make_surface(
      Domain::square,
      {test::height_patch(test::plane(), 0, 0, 2, 1), test::height_patch(test::plane(), 0, 1, 1, 1),
       test::height_patch(test::plane(), 1, 1, 1, 1)},
      {0, 1, 2, 3, 3, 4, 5, 6, 4, 2, 7, 5});
  Surface::Parts parts;
  parts.patches = std::shared_ptr<const PatchSet>(std::make_shared<Surface>(pieces), &pieces.patches());
  std::vector<Seam> seams = pieces.seams();
  ASSERT_EQ(seams.size(), 1U);  // between the two narrow ones
  seams.push_back({{0, 2}, {1, 0}, Continuity::g1, 0.5, 1, 1, 0, {}});
  seams.push_back({{0, 2}, {2, 0}, Continuity::g1, 0, 0.5, 1, 0, {}});
  parts.seams = std::make_shared<const std::vector<Seam>>(seams);
  parts.provenance = std::make_shared<const std::vector<Provenance>>(3);
  parts.corner_nodes =
      std::make_shared<const std::vector<Index>>(std::vector<Index>{0, 1, 2, 3, 3, 4, 5, 6, 4, 2, 7, 5});
  parts.node_count = 8;
  parts.node_normals = std::make_shared<const std::vector<Vector3>>(8, Vector3::Zero());
  parts.boundary_sides = std::make_shared<const std::vector<PatchSide>>();
  parts.boundary_sources = std::make_shared<const std::vector<Element>>();
  const Surface surface(parts);
  const Adjacency adjacency(surface);
  EXPECT_EQ(adjacency.full_seam({0, 2}), no_index);
  EXPECT_EQ(adjacency.seams({0, 2}).size(), 2U);
  for (const PatchSide& side : adjacency.boundary()) EXPECT_FALSE(side == (PatchSide{0, 2}));
  EXPECT_EQ(adjacency.boundary().size(), 3U + 2U + 2U);
}

}  // namespace
}  // namespace hariko

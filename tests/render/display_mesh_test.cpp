#include "render/display_mesh.hpp"

#include <set>

#include "render/surface_maps.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

Vector3 as_vector(const std::array<float, 3>& a) {
  return {double(a[0]), double(a[1]), double(a[2])};
}

TEST(DisplayMesh, VerticesAndNormalsAreTheSurfaces) {
  const Surface surface = sphere(3);
  const auto mesh = DisplayMesh::build(surface, map_options(SurfaceMap::shaded, 6));
  ASSERT_EQ(mesh->patch_count(), 8U);
  ASSERT_EQ(mesh->vertex_count(), 8U * 28U);
  EXPECT_EQ(mesh->triangle_count(), 8U * 36U);
  const auto parameters = mesh->pattern().parameters();
  for (std::size_t i = 0; i < mesh->vertex_count(); ++i) {
    const DisplayVertex& vertex = mesh->vertex(i);
    const Vector3 exact =
        surface.patches().evaluate(static_cast<Index>(i / 28), parameters[i % 28], Order::first).position;
    EXPECT_LT((as_vector(vertex.position) - exact).norm(), 1e-6);
    EXPECT_LT((as_vector(vertex.normal) - exact.normalized()).norm(), 1e-6);
  }
  EXPECT_NEAR(mesh->box().max().x(), 3, 1e-6);
  EXPECT_FALSE(mesh->has_values());
  EXPECT_TRUE(std::isnan(mesh->value(0)));
}

TEST(DisplayMesh, CurvesFollowTheSeamsAndJoin) {
  const Surface surface = sphere(1);
  const auto mesh = DisplayMesh::build(surface, map_options(SurfaceMap::shaded, 5));
  std::size_t segments = 0;
  for (const DisplayCurve& curve : mesh->curves()->curves) {
    const auto& all = mesh->curves()->segments[std::size_t(curve.kind)];
    ASSERT_EQ(curve.segment_count, 5U);
    for (Index i = 0; i < curve.segment_count; ++i) {
      const auto& s = all[curve.first_segment + i].vertices;
      if (i > 0) {
        EXPECT_EQ(s[0], all[curve.first_segment + i - 1].vertices[1]);
      }
      if (i > 0) {
        EXPECT_EQ(s[1], all[curve.first_segment + i - 1].vertices[2]);
      }
      if (i == 0) {
        EXPECT_EQ(s[0], s[1]);
      }
      if (i + 1 == curve.segment_count) {
        EXPECT_EQ(s[3], s[2]);
      }
      const Vector3 a = as_vector(mesh->vertex(s[1]).position);
      EXPECT_LT(a.cwiseAbs().minCoeff(), 1e-6);  // the sides of octants lie in the coordinate planes
    }
    segments += curve.segment_count;
  }
  EXPECT_EQ(segments, 12U * 5U);
}

TEST(DisplayMesh, MapValuesAreTheCurvatures) {
  const auto mesh = DisplayMesh::build(sphere(2), map_options(SurfaceMap::gaussian, 4));
  ASSERT_TRUE(mesh->has_values());
  const auto values = mesh->defined_values();
  ASSERT_GT(values.size(), mesh->vertex_count() / 2);
  for (const float value : values) EXPECT_NEAR(double(value), 0.25, 1e-5);
}

TEST(DisplayMesh, SeamValuesComeWithTheContinuityMap) {
  const Surface surface = torus(3, 1, 6, 5);
  const auto mesh = DisplayMesh::build(surface, map_options(SurfaceMap::continuity, 4));
  EXPECT_EQ(mesh->seam_values()->size(), surface.seams().size() * 5);
  for (const float value : mesh->defined_seam_values()) EXPECT_NEAR(double(value), 0, 1e-6);
}

TEST(DisplayMesh, ARefreshedMeshEqualsANewOneAndSharesTheRest) {
  // 20 x 10 unit squares of a height field; some of them rise.
  const auto field = [](double lift, const std::set<Index>& raised) {
    return height_field(
        20, 10, [=](Index i, Index j) { return plane(0, 0, raised.contains(j * 20 + i) ? lift : 0.0); });
  };
  for_random(10, 10, [&](std::mt19937_64& rng) {
    std::set<Index> raised;
    for (int k = uniform_int(rng, 0, 6); k > 0; --k)
      raised.insert(static_cast<Index>(uniform_int(rng, 0, 199)));
    const Surface before = field(0, {}), after = field(1, raised);
    const DisplayOptions options = map_options(SurfaceMap::mean, 3);
    const auto base = DisplayMesh::build(before, options);
    const std::vector<Index> changed(raised.begin(), raised.end());
    const auto refreshed = base->refreshed(after, changed);
    const auto fresh = DisplayMesh::build(after, options);
    std::set<Index> touched;
    for (const Index p : raised) touched.insert(p / DisplayMesh::patches_per_chunk);
    ASSERT_EQ(refreshed->chunks().size(), 7U);
    for (Index c = 0; c < 7; ++c) {
      EXPECT_EQ(refreshed->chunks()[c] == base->chunks()[c], !touched.contains(c));
      const auto& a = *refreshed->chunks()[c];
      const auto& b = *fresh->chunks()[c];
      ASSERT_EQ(a.vertices.size(), b.vertices.size());
      for (std::size_t i = 0; i < a.vertices.size(); ++i)
        EXPECT_EQ(a.vertices[i].position, b.vertices[i].position);
      EXPECT_EQ(a.box.max(), b.box.max());
    }
    EXPECT_EQ(refreshed->box().max(), fresh->box().max());
    EXPECT_EQ(refreshed->curves(), base->curves());
  });
}

TEST(DisplayMesh, DensityFollowsTheBudget) {
  EXPECT_EQ(display_density(8), 32);
  EXPECT_EQ(display_density(80'000), 3);
  EXPECT_EQ(display_density(0), 32);
  const int middle = display_density(2'000);
  EXPECT_GT(middle, 3);
  EXPECT_LE(2'000.0 * middle * middle, 200'000);
  EXPECT_LT(display_density(2'000, Domain::square), middle);
}

TEST(DisplayMesh, CancelledIsNull) {
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(DisplayMesh::build(sphere(1), map_options(SurfaceMap::shaded, 4), cancel), nullptr);
}

TEST(DisplayMesh, ASurfaceWithoutPatchesIsEmpty) {
  const auto mesh = DisplayMesh::build(Surface(), map_options(SurfaceMap::shaded, 4));
  ASSERT_NE(mesh, nullptr);
  EXPECT_EQ(mesh->vertex_count(), 0U);
  EXPECT_TRUE(mesh->box().isEmpty());
}

}  // namespace
}  // namespace hariko::test

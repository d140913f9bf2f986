// Gauss sphere, an outline's second view: its image, sites, cells and tangent planes, step by step.

#include "core/gaussmap/sphere/gauss_sphere.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/gaussmap/truths.hpp"

namespace hariko::test {
namespace {

double total_angle(const SphereMesh& mesh) {
  double sum = 0;
  for (Index i = 0; i < mesh.site_count(); ++i) sum += mesh.solid_angle(i);
  return sum;
}

TEST(GaussSphere, SitesComeOneByOne) {
  const GroundTruth truth = ellipsoid_cap(24);
  const OutlineSettings settings = usual_settings(truth.outline);
  const GaussSphere whole = gauss_sphere(truth.outline, settings, {});
  ASSERT_TRUE(whole.mesh && whole.points && !whole.error);
  EXPECT_EQ(whole.mesh->inner_count(), whole.inserted);
  ASSERT_GT(whole.inserted, 10u);
  std::vector<Vector3> before;
  for (const Index step : {0u, 1u, 2u, 7u, whole.inserted - 1}) {
    SCOPED_TRACE(step);
    const GaussSphere some = gauss_sphere(truth.outline, settings, step);
    ASSERT_TRUE(some.mesh && some.points);
    EXPECT_EQ(some.inserted, whole.inserted);
    EXPECT_EQ(some.mesh->inner_count(), step);
    EXPECT_EQ(some.points->points.size(), 24 + step);
    // Those that were there stay where they were.
    EXPECT_TRUE(std::equal(before.begin(), before.end(), some.mesh->sites().begin()));
    before = some.mesh->sites();
    EXPECT_NEAR(total_angle(*some.mesh), total_angle(*whole.mesh), 1e-10);
  }
  const GaussSphere beyond = gauss_sphere(truth.outline, settings, whole.inserted + 5);
  EXPECT_EQ(beyond.mesh->sites(), whole.mesh->sites());
}

TEST(GaussSphere, FacetsLieInThePlanesOfTheirNeighbours) {
  const GroundTruth truth = sphere_cap(24);
  const GaussSphere sphere = gauss_sphere(truth.outline, usual_settings(truth.outline), {});
  for (Index i = 0; i < sphere.mesh->site_count(); ++i) {
    const std::vector<Vector3> facet = tangent_facet(sphere, i);
    if (sphere.mesh->is_boundary(i)) {
      EXPECT_TRUE(facet.empty());
      continue;
    }
    const auto& ring = sphere.mesh->ring(i);
    ASSERT_EQ(facet.size(), ring.neighbours.size());
    for (std::size_t k = 0; k < facet.size(); ++k) {
      const Index next = ring.neighbours[(k + 1) % facet.size()];
      for (const Index site : {i, ring.neighbours[k], next})
        EXPECT_NEAR(sphere.points->normals[site].dot(facet[k]), sphere.points->support[site], 1e-9);
      // Round the control point, counter-clockwise: the facet of a convex polyhedron.
      const Vector3 a = facet[k] - sphere.points->points[i],
                    b = facet[(k + 1) % facet.size()] - sphere.points->points[i];
      EXPECT_GT(sphere.mesh->site(i).dot(a.cross(b)), 0);
    }
  }
}

TEST(GaussSphere, NegativeCurvatureAndPosition) {
  const GroundTruth truth = saddle_disc(24);
  const GaussSphere sphere = gauss_sphere(truth.outline, usual_settings(truth.outline), {});
  ASSERT_TRUE(sphere.mesh);
  // The triangles lie on the left of the reversed loop.
  EXPECT_EQ(sphere.mesh->next(1), 0u);
  EXPECT_GT(total_angle(*sphere.mesh), 0);
  OutlineSettings settings;
  settings.mode = GaussMode::position;
  const GaussSphere bent = gauss_sphere(truth.outline, settings, {});
  EXPECT_TRUE(bent.points && !bent.mesh && !bent.error);
  EXPECT_GT(bent.inserted, 0u);
}

TEST(GaussSphere, OneSiteOnMoreThanAHemisphere) {
  // Its neighbours are more than a right angle away: none of them tells where the contact point is.
  const Truth truth = ellipsoid(Vector3::Ones());
  const Outline outline{{circle_of_normals(truth, Vector3::UnitZ(), 2 * pi / 3, 32, false)}};
  const GaussSphere sphere = gauss_sphere(outline, usual_settings(outline), 1);
  ASSERT_TRUE(sphere.points && sphere.mesh);
  ASSERT_EQ(sphere.points->points.size(), 33u);
  EXPECT_LE((sphere.points->points.back() - Vector3::UnitZ()).norm(), 1e-9);
}

TEST(GaussSphere, AnErrorLeavesTheImage) {
  const Outline outline = golden_outline("bad_figure8");
  const GaussSphere sphere = gauss_sphere(outline, {}, {});
  ASSERT_TRUE(sphere.error);
  EXPECT_FALSE(sphere.mesh);
  EXPECT_EQ(sphere.inserted, 0u);
  ASSERT_EQ(sphere.loops.size(), 1u);
  EXPECT_EQ(sphere.loops[0].size(), outline.loops[0].points.size());
  EXPECT_TRUE(tangent_facet(sphere, 0).empty());
}

}  // namespace
}  // namespace hariko::test

// Deviations: signed distances from moved copies, at edges, and far away.

#include "core/approximation/deviation.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

#include "core/surface/facets.hpp"
#include "core/surface/surface_triangles.hpp"
#include "tests/approximation/surfaces.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

using Kind = DeviationReference::Kind;

std::vector<float> deviations(const Surface& surface, const DeviationReference& reference,
                              const ToReference& place, double scale = 1) {
  const GridPattern pattern{surface.domain(), 5};
  std::vector<Index> patches(surface.patch_count());
  std::iota(patches.begin(), patches.end(), Index{0});
  std::vector<float> out(std::size_t(pattern.point_count()) * patches.size());
  deviation_values(surface, reference, place, scale, patches, pattern, out);
  return out;
}

Surface plate() {
  return test::height_field(2, 2, [](Index, Index) { return test::plane(); });
}

Surface as_facets(const Surface& surface, int density) {
  const SurfaceTriangles parts = surface_triangles(surface, density);
  return facet_surface(surface.origin(), parts.positions, parts.triangles,
                       std::vector<Element>(parts.triangles.size()));
}

TEST(Deviation, OfAMovedCopyIsTheWay) {
  const DeviationReference smooth(plate(), Kind::smooth), facets(as_facets(plate(), 3), Kind::facets);
  for (const double way : {0.25, -0.25, 1e-6, 0.0})
    for (const DeviationReference* reference : {&smooth, &facets})
      for (const float value : deviations(plate(), *reference, {Matrix3::Identity(), Vector3(0, 0, way)}))
        EXPECT_NEAR(value, way, 1e-9) << way;
}

TEST(Deviation, OfAConcentricSphereIsTheDifferenceOfRadii) {
  for (const double size : {1e-3, 1.0, 1e6}) {
    SCOPED_TRACE(size);
    const DeviationReference smooth(test::sphere(2 * size), Kind::smooth);
    for (const float value : deviations(test::sphere(2.5 * size), smooth, {}))
      EXPECT_NEAR(value, 0.5 * size, 1e-6 * size) << "outside";
    for (const float value : deviations(test::sphere(1.75 * size), smooth, {}))
      EXPECT_NEAR(value, -0.25 * size, 1e-6 * size) << "inside";
    // The deviation of itself is nothing, whatever the fine mesh of the search misses.
    for (const float value : deviations(test::sphere(2 * size), smooth, {}))
      EXPECT_NEAR(value, 0, 1e-9 * size);
    // Twice as large in its own space, and measured in a world where its unit is half as long.
    for (const float value :
         deviations(test::sphere(1.25 * size), smooth, {2 * Matrix3::Identity(), Vector3::Zero()}, 0.5))
      EXPECT_NEAR(value, 0.25 * size, 1e-6 * size);
  }
}

TEST(Deviation, IsAsExactFarAway) {
  test::AnalyticOptions far;
  far.origin = Vector3(1e6, -1e6, 1e6);
  const Surface reference = test::sphere(2, far);
  const DeviationReference smooth(reference, Kind::smooth);
  const Surface moved = test::sphere(2.5, far);
  for (const float value :
       deviations(moved, smooth, {Matrix3::Identity(), moved.origin() - reference.origin()}))
    EXPECT_NEAR(value, 0.5, 1e-6);
}

TEST(Deviation, RoundAndFacetedReferencesAgree) {
  const Surface ball = test::sphere(2);
  const DeviationReference smooth(ball, Kind::smooth), facets(as_facets(ball, 40), Kind::facets);
  const ToReference place{Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix(),
                          Vector3(0.1, -0.2, 0.3)};
  const auto a = deviations(test::torus(3, 1, 6, 4), smooth, place),
             b = deviations(test::torus(3, 1, 6, 4), facets, place);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 2e-3);
}

TEST(Deviation, OutsideOfASharpEdgeIsOutside) {
  // Two planes that meet in an acute roof over y.
  const auto slope = [](Index i, Index) { return test::plane(i == 0 ? 4.0 : -4.0, 0, i == 0 ? 0.0 : 8.0); };
  const Surface roof = test::height_field(2, 1, slope);
  const Vector3 ridge(1, 0.5, 4);
  for (const Kind kind : {Kind::smooth, Kind::facets}) {
    const DeviationReference reference(kind == Kind::smooth ? roof : as_facets(roof, 2), kind);
    for (const double lean : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
      const Vector3 above = ridge + Vector3(lean, 0, 0.3);
      EXPECT_NEAR(reference.signed_distance(above), (above - ridge).norm(), 1e-6) << lean;
    }
    EXPECT_LT(reference.signed_distance(ridge - Vector3(0.01, 0, 0.5)), 0);
  }
}

TEST(Deviation, ClosedSpheresWithPolesAreClosed) {
  const Surface ball = weld_patches(Vector3::Zero(), test::rational_sphere(2)).value();
  EXPECT_TRUE(is_closed(ball)) << "sides that are shrunk to a pole are no border";
  const DeviationReference smooth(ball, Kind::smooth);
  EXPECT_NEAR(smooth.signed_distance({0, 0, 3}), 1, 1e-6);
  EXPECT_NEAR(smooth.signed_distance({0.2, 0.1, 0.3}), std::hypot(0.2, 0.1, 0.3) - 2, 1e-6);
}

}  // namespace
}  // namespace hariko

// Offsets and shells of surfaces with closed forms: radii, volumes, folds and sharp edges, at all sizes.

#include "core/offset/offset_surface.hpp"

#include "core/analysis/curvature.hpp"
#include "core/approximation/approximate.hpp"
#include "core/cad/cad_measure.hpp"
#include "core/cad/cad_model.hpp"
#include "tests/approximation/surfaces.hpp"
#include "tests/offset/walls.hpp"

namespace hariko {
namespace {

constexpr double pi = std::numbers::pi;

TriangleMesh meshed(const Surface& surface, double distance) {
  MeshOptions options;
  options.criteria.distance = distance;
  return test::must(approximate(surface, options)).value().mesh;
}

/// Surface at a distance, positive outside.
Result<OffsetSurface> offset_surface(const Surface& surface, double distance) {
  return wall_surface(surface, {distance, 0, WallSide::inside});
}

/// Sizes from a thousandth to a million.
class OffsetAtAllSizes : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Offset, OffsetAtAllSizes, testing::Values(1e-3, 1.0, 1e6));

TEST_P(OffsetAtAllSizes, SphereHasItsRadiusAndCurvature) {
  const double size = GetParam();
  const Surface base = test::sphere(size);
  for (const double distance : {0.25 * size, -0.25 * size, 3 * size}) {
    const auto made = test::must(offset_surface(base, distance));
    EXPECT_TRUE(made->warnings.empty());
    const PatchSet& patches = made->surface.patches();
    const double radius = size + distance;
    for (Index p = 0; p < patches.patch_count(); ++p)
      for (const Vector2& at : GridPattern{Domain::triangle, 5}.parameters()) {
        const PatchPoint point = patches.evaluate(p, at, Order::second);
        EXPECT_NEAR(point.position.norm(), radius, 1e-12 * radius);
        const auto k = curvature(point);
        ASSERT_TRUE(k);
        EXPECT_NEAR(k->k1 * radius, 1, 1e-9);
        EXPECT_NEAR(k->k2 * radius, 1, 1e-9);
        EXPECT_NEAR(k->normal.dot(point.position), radius, 1e-9 * radius);
      }
  }
}

TEST_P(OffsetAtAllSizes, CylinderHasItsRadius) {
  const double size = GetParam();
  const auto made = test::must(offset_surface(test::tube(size, 3 * size, pi, 3, 2), -0.5 * size));
  for (Index p = 0; p < made->surface.patch_count(); ++p)
    for (const Vector2& at : GridPattern{Domain::square, 4}.parameters()) {
      const Vector3 q = made->surface.patches().evaluate(p, at, Order::first).position;
      EXPECT_NEAR(q.head<2>().norm(), 0.5 * size, 1e-12 * size);
    }
}

TEST_P(OffsetAtAllSizes, DerivativesAreThoseOfThePositions) {
  const double size = GetParam();
  const auto made = test::must(offset_surface(test::torus(3 * size, size, 5, 4), 0.4 * size));
  const PatchSet& patches = made->surface.patches();
  constexpr double h = 1e-5;
  const Vector2 at(0.3, 0.6);
  const PatchPoint p = patches.evaluate(7, at, Order::second);
  const auto moved = [&](double s, double t) {
    return patches.evaluate(7, at + Vector2(s, t), Order::first);
  };
  EXPECT_LT((p.ds - (moved(h, 0).position - moved(-h, 0).position) / (2 * h)).norm(), 1e-8 * size);
  EXPECT_LT((p.dt - (moved(0, h).position - moved(0, -h).position) / (2 * h)).norm(), 1e-8 * size);
  EXPECT_LT((p.dst - (moved(0, h).ds - moved(0, -h).ds) / (2 * h)).norm(), 1e-7 * size);
  EXPECT_LT((p.dss - (moved(h, 0).ds - moved(-h, 0).ds) / (2 * h)).norm(), 1e-7 * size);
}

TEST_P(OffsetAtAllSizes, ShellOfASphereHasItsVolume) {
  const double size = GetParam();
  for (const double inner : {0.8, -0.2}) {
    const Surface base = test::sphere(size);
    const double outer = inner + 0.1;
    const auto made = test::must(wall_surface(base, {inner * size, 0.1 * size, WallSide::outside}));
    const double tolerance = 1e-3 * size;
    const TriangleMesh mesh = meshed(made->surface, tolerance);
    test::expect_watertight(mesh);
    const double a = 1 + outer, b = 1 + inner;
    EXPECT_NEAR(test::volume(mesh) / (size * size * size), 4 * pi / 3 * (a * a * a - b * b * b),
                4 * pi * (a * a + b * b) * 1e-3);
  }
}

TEST_P(OffsetAtAllSizes, ShellOfAnOpenHalfTubeHasItsVolume) {
  const double size = GetParam();
  const Surface base = test::tube(size, 2 * size, pi, 3, 2);
  for (const WallSide side : {WallSide::inside, WallSide::outside, WallSide::both}) {
    const auto made = test::must(wall_surface(base, {0, 0.2 * size, side}));
    EXPECT_TRUE(made->warnings.empty());
    EXPECT_EQ(made->gaps, 0U);
    const TriangleMesh mesh = meshed(made->surface, 5e-4 * size);
    test::expect_watertight(mesh);
    test::expect_watertight(tessellate(made->surface, 5));
    const double a = side == WallSide::inside ? 1 : side == WallSide::outside ? 1.2 : 1.1, b = a - 0.2;
    EXPECT_NEAR(test::volume(mesh) / (size * size * size), pi / 2 * (a * a - b * b) * 2, 5e-3);
  }
}

TEST_P(OffsetAtAllSizes, TorusFoldsAtTheRadiusOfItsTube) {
  const double size = GetParam();
  const Surface base = test::torus(3 * size, size, 7, 5);
  const auto folds = offset_folds(base, -0.999 * size);
  EXPECT_EQ(folds.patches, 0U);
  EXPECT_NEAR(folds.inside, size, 1e-9 * size);
  // The inner equator bends the other way round the axis, with the radius 3 - 1.
  EXPECT_NEAR(folds.outside, 2 * size, 1e-6 * size);
  EXPECT_EQ(offset_folds(base, -1.001 * size).patches, 35U);
  EXPECT_EQ(offset_folds(base, 1.99 * size).patches, 0U);
  EXPECT_GT(offset_folds(base, 2.01 * size).patches, 0U);

  const auto fine = offset_surface(base, 1.9 * size), folded = offset_surface(base, -1.1 * size);
  ASSERT_TRUE(fine.ok() && folded.ok());
  EXPECT_TRUE(fine->warnings.empty());
  ASSERT_EQ(folded->warnings.size(), 1U);
  EXPECT_EQ(folded->warnings[0].code, w_offset_folds);
}

TEST_P(OffsetAtAllSizes, SharpEdgesAndCornersOfACubeBecomeRound) {
  const double size = GetParam(), d = 0.3;
  for (const Domain domain : {Domain::square, Domain::triangle}) {
    const auto made = test::must(offset_surface(test::cube(size, domain), d * size));
    EXPECT_EQ(made->sharp_edges, 12U);
    EXPECT_EQ(made->crossings, 0U);
    EXPECT_TRUE(made->warnings.empty());
    const TriangleMesh mesh = meshed(made->surface, 5e-4 * size);
    test::expect_watertight(mesh);
    test::expect_watertight(tessellate(made->surface, 4));
    // Steiner's formula.
    EXPECT_NEAR(test::volume(mesh) / (size * size * size),
                1 + 6 * d + 3 * pi * d * d + 4 * pi / 3 * d * d * d, 2e-3);
    const auto narrow = test::must(offset_surface(test::cube(size, domain), -0.2 * size));
    EXPECT_EQ(narrow->crossings, 12U);
    ASSERT_FALSE(narrow->warnings.empty());
    EXPECT_EQ(narrow->warnings[0].code, w_offset_crosses);
  }
}

TEST_P(OffsetAtAllSizes, ShellOfAnOpenBoxIsClosed) {
  const double size = GetParam(), d = 0.2;
  for (const Domain domain : {Domain::square, Domain::triangle}) {
    const auto made = wall_surface(test::cube(size, domain, true), {0, d * size, WallSide::outside});
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(made->gaps, 0U);
    const TriangleMesh mesh = meshed(made->surface, 5e-4 * size);
    test::expect_watertight(mesh);
    test::expect_watertight(tessellate(made->surface, 4));
    // Five sides, eight quarters of cylinders, four octants.
    EXPECT_NEAR(test::volume(mesh) / (size * size * size),
                5 * d + 8 * pi / 4 * d * d + 2 * pi / 3 * d * d * d, 2e-3);
    const auto both =
        test::must(wall_surface(test::cube(size, domain, true), {0.5 * d * size, d * size, WallSide::both}));
    test::expect_watertight(tessellate(both->surface, 4));
  }
}

TEST(Offset, PolesStayPoints) {
  const Surface base = weld_patches(Vector3::Zero(), test::rational_sphere(2)).value();
  const auto made = test::must(wall_surface(base, {-0.5, 1, WallSide::outside}));
  EXPECT_TRUE(made->warnings.empty());
  const TriangleMesh mesh = meshed(made->surface, 4e-3);
  test::expect_watertight(mesh);
  EXPECT_NEAR(test::volume(mesh), 4 * pi / 3 * (2.5 * 2.5 * 2.5 - 1.5 * 1.5 * 1.5), 0.4);
}

TEST(Offset, CadFacesOfAnOffsetKeepTheTolerance) {
  const auto sphere = offset_surface(test::sphere(10), 1);
  const auto tube = wall_surface(test::tube(10, 20, pi, 2, 1), {0, 2, WallSide::inside});
  const auto box = wall_surface(test::cube(10, Domain::square, true), {0, 1, WallSide::outside});
  ASSERT_TRUE(sphere.ok() && tube.ok() && box.ok());
  for (const Surface* surface : {&sphere->surface, &tube->surface, &box->surface}) {
    CadModelOptions options{.tolerance = 1e-3};
    options.share = 0;
    const auto model = test::must(make_cad_model(*surface, options));
    EXPECT_TRUE(model->closed());
    const CadMeasure measure = measure_cad(*surface, *model, 4);
    EXPECT_LT(measure.largest, 1e-3);
  }
}

TEST(Offset, WrongLengthsAreRefused) {
  const Surface base = test::sphere(1);
  EXPECT_EQ(offset_surface(base, std::nan("")).error().code, e_offset_distance);
  EXPECT_EQ(wall_surface(base, {0, -1, WallSide::both}).error().code, e_offset_distance);
  EXPECT_EQ(offset_surface(Surface{}, 1).error().code, e_offset_nothing);
}

}  // namespace
}  // namespace hariko

// Curvature combs: right on circles, and equal to differences of positions on real surfaces.

#include "core/analysis/combs.hpp"

#include "core/patching/polyhedron_surface.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

test::AnalyticOptions with_sources() {
  test::AnalyticOptions options;
  options.source_edges = true;
  return options;
}

TEST(Combs, GreatCirclesOfASphere) {
  const double radius = 2.5;
  const CurvatureCombs combs = curvature_combs(test::sphere(radius, with_sources()), 8);
  ASSERT_EQ(combs.curve_count(), 12U);
  ASSERT_EQ(combs.teeth.size(), 12U * 9U);
  for (std::size_t i = 0; i < combs.teeth.size(); ++i) {
    EXPECT_NEAR(combs.points[i].norm(), radius, 1e-13);
    EXPECT_LT((combs.teeth[i] - combs.points[i] / (radius * radius)).norm(), 1e-12) << "outwards, 1 / radius";
  }
  EXPECT_NEAR(typical_curvature(combs), 1 / radius, 1e-12);
}

TEST(Combs, CirclesOfATorus) {
  const double large = 3, small = 1;
  const CurvatureCombs combs = curvature_combs(test::torus(large, small, 6, 5, with_sources()), 10);
  ASSERT_EQ(combs.curve_count(), 60U);
  std::size_t round_tube = 0, round_axis = 0;
  for (std::size_t i = 0; i < combs.teeth.size(); ++i) {
    const Vector3& p = combs.points[i];
    const double ring = std::hypot(p.x(), p.y());
    const Vector3 middle(large * p.x() / ring, large * p.y() / ring, 0);
    const bool tube = (combs.teeth[i] - (p - middle) / (small * small)).norm() < 1e-12;
    const bool axis = (combs.teeth[i] - Vector3(p.x(), p.y(), 0) / (ring * ring)).norm() < 1e-12;
    EXPECT_TRUE(tube || axis) << p.transpose();
    round_tube += tube;
    round_axis += axis;
  }
  EXPECT_GE(round_tube, 330U);
  EXPECT_GE(round_axis, 330U);
}

TEST(Combs, StraightCurvesHaveNone) {
  const CurvatureCombs combs =
      curvature_combs(test::height_field(
                          2, 2, [](Index, Index) { return test::saddle(); }, with_sources()),
                      4);
  ASSERT_EQ(combs.curve_count(), 4U);
  for (const Vector3& tooth : combs.teeth) EXPECT_LT(tooth.norm(), 1e-15) << "rulings of a saddle";
  EXPECT_LT(typical_curvature(combs), 1e-15);
  EXPECT_EQ(typical_curvature({}), 0);
}

TEST(Combs, InnerEdgesOfSourceElementsHaveNone) {
  EXPECT_EQ(curvature_combs(test::sphere(1), 4).curve_count(), 0U);
}

/// The comb of a curve given by its positions, by differences.
Vector3 tooth_by_differences(const Surface& surface, PatchSide side, double x) {
  // Derivatives at an end come from inside the curve: the differences are taken at h, 2h, 3h, 4h off it.
  const double h = 1e-3, to = x > 0.5 ? -h : h;
  const auto at = [&](int k) -> Vector3 {
    return surface.patches()
        .evaluate(side.patch, side_parameter(surface.domain(), side.side, x + k * to), Order::first)
        .position;
  };
  const Vector3 first = (-25 * at(0) + 48 * at(1) - 36 * at(2) + 16 * at(3) - 3 * at(4)) / (12 * to);
  const Vector3 second =
      (45 * at(0) - 154 * at(1) + 214 * at(2) - 156 * at(3) + 61 * at(4) - 10 * at(5)) / (12 * to * to);
  const double speed = first.squaredNorm();
  return -(second - first * (first.dot(second) / speed)) / speed;
}

TEST(Combs, OfSurfacesEqualDifferencesOfPositions) {
  test::for_random(71, 20, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = test::chance(rng, 0.5) ? test::prism(test::uniform_int(rng, 3, 8))
                                                    : test::grid(test::uniform_int(rng, 2, 4), 3);
    const Polyhedron polyhedron = Polyhedron::build(mesh).value();
    const auto built = test::must(PolyhedronSurfacer().rebuild({polyhedron, {}}));
    const Surface& surface = built->surface;
    constexpr int density = 6;
    const CurvatureCombs combs = curvature_combs(surface, density);
    ASSERT_EQ(combs.curve_count(), polyhedron.edge_count());
    const double size = typical_curvature(combs) + 1e-3;
    std::size_t curve = 0;
    const auto compare = [&](PatchSide side) {
      for (int i = 0; i <= density; ++i) {
        const Vector3& tooth = combs.teeth[curve * (density + 1) + static_cast<std::size_t>(i)];
        EXPECT_LT((tooth - tooth_by_differences(surface, side, double(i) / density)).norm(), 1e-4 * size)
            << "curve " << curve << " tooth " << i;
      }
      ++curve;
    };
    for (const Seam& seam : surface.seams())
      if (seam.source.kind == Element::Kind::edge) compare(seam.first);
    for (const PatchSide& side : surface.boundary_sides()) compare(side);
  });
}

TEST(Combs, CancelledGivesNothing) {
  const CancelToken token = CancelToken::make();
  token.cancel();
  EXPECT_EQ(curvature_combs(test::sphere(1, with_sources()), 4, token).curve_count(), 0U);
}

}  // namespace
}  // namespace hariko

// Lines along surfaces: marks sorted by class, combs as they were computed, sections that lie on the plane
// and close.

#include "render/surface_lines.hpp"

#include <map>
#include <numbers>

#include "core/patching/polyhedron_surface.hpp"
#include "render/surface_maps.hpp"
#include "tests/support/analytic_patches.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

AnalyticOptions with_sources() {
  AnalyticOptions options;
  options.source_edges = true;
  return options;
}

std::shared_ptr<const DisplayMesh> mesh_of(const Surface& surface, int density) {
  return DisplayMesh::build(surface, map_options(SurfaceMap::shaded, density));
}

TEST(SurfaceLines, SectionsLieOnThePlaneAndClose) {
  for_random(5, 40, [](std::mt19937_64& rng) {
    const PolygonMesh shape = random_closed_shape(rng);
    const auto built = must(PolyhedronSurfacer().rebuild({Polyhedron::build(shape).value(), {}}));
    const auto mesh = mesh_of(built->surface, uniform_int(rng, 2, 7));
    const Vector3 normal = (random_vector(rng) + Vector3(0, 0, 1.01)).normalized();
    // Between the ends of an edge: shapes of several parts may have none of them at the middle of their box.
    const auto face = shape.face(std::size_t(uniform_int(rng, 0, int(shape.face_count()) - 1)));
    const Vector3 middle = (shape.positions[face[0]] + shape.positions[face[1]]) / 2;
    const LocalPlane plane{normal, normal.dot(middle - mesh->origin())};
    const double size = mesh->box().sizes().norm();
    const auto pieces = section_curve(*mesh, plane);
    ASSERT_FALSE(pieces.empty());
    std::map<std::array<float, 3>, int> ends;
    for (const auto& piece : pieces)
      for (const auto& end : piece) {
        ++ends[end];
        const Vector3 p{double(end[0]), double(end[1]), double(end[2])};
        EXPECT_NEAR(normal.dot(p), plane.offset, 1e-6 * size);
      }
    // Both sides of a seam give the same bits, so the pieces of a closed surface meet.
    for (const auto& [end, count] : ends) EXPECT_EQ(count % 2, 0) << "a closed surface has closed sections";
  });
}

TEST(SurfaceLines, ASectionHasTheLengthOfItsCircle) {
  const auto mesh = mesh_of(sphere(2), 24);
  double length = 0;
  for (const auto& [a, b] : section_curve(*mesh, {Vector3::UnitZ(), 1}))
    length += std::hypot(double(a[0]) - double(b[0]), double(a[1]) - double(b[1]));
  EXPECT_NEAR(length, 2 * std::numbers::pi * std::sqrt(3.0), 0.02);
  EXPECT_TRUE(section_curve(*mesh, {Vector3::UnitZ(), 2.5}).empty());
}

TEST(SurfaceLines, FacetsShareTheirEdges) {
  const std::vector<Vector3> corners{Vector3::Zero(), Vector3::UnitX(), Vector3::UnitY(), Vector3(1, 1, 0)};
  const std::vector<std::array<Index, 3>> triangles{{0, 1, 2}, {3, 2, 1}};
  const auto lines = facet_lines(Vector3(5, 0, 0), corners, triangles, 0.25);
  ASSERT_EQ(lines->edges.size(), 5U) << "the diagonal is drawn once";
  EXPECT_EQ(lines->points.size(), corners.size());
  EXPECT_EQ(lines->origin, Vector3(5, 0, 0));
  EXPECT_EQ(lines->depth, 0.25);
  EXPECT_EQ(std::count(lines->edges.begin(), lines->edges.end(), std::array<Index, 2>{1, 2}), 1);
}

TEST(SurfaceLines, MarksAreSortedByClass) {
  const Surface surface = sphere(1, with_sources());
  const auto mesh = mesh_of(surface, 8);
  std::vector<Continuity> classes(12, Continuity::g2);
  classes[3] = Continuity::g0;
  classes[5] = classes[7] = Continuity::g1;
  const auto marks = edge_marks(*mesh, classes);
  EXPECT_EQ(marks->classes[0].curves, 1U);
  EXPECT_EQ(marks->classes[1].curves, 2U);
  EXPECT_EQ(marks->classes[2].curves, 9U);
  for (const auto& one : marks->classes) {
    ASSERT_EQ(one.segments.size(), 8 * one.curves);
    ASSERT_EQ(one.lengths.size(), one.segments.size());
    for (std::size_t i = 0; i < one.lengths.size(); ++i) {
      EXPECT_LT(one.lengths[i][0], one.lengths[i][1]);
      if (i % 8 == 0) {
        EXPECT_EQ(one.lengths[i][0], 0.0F) << "each curve begins anew";
      }
      if (i % 8 == 7) {
        EXPECT_NEAR(double(one.lengths[i][1]), std::numbers::pi / 2, 0.01) << "a quarter";
      }
    }
  }
  const auto inner = edge_marks(*mesh_of(sphere(1), 4), std::vector<Continuity>(12, Continuity::g1));
  EXPECT_TRUE(inner->classes[1].segments.empty()) << "edges inside source elements have no marks";
}

TEST(SurfaceLines, CombsKeepFeetTeethAndSizes) {
  const CurvatureCombs combs = curvature_combs(torus(3, 1, 5, 4, with_sources()), 6);
  const auto lines = comb_lines(combs, {1, 2, 3});
  EXPECT_EQ(lines->origin, Vector3(1, 2, 3));
  EXPECT_EQ(lines->density, 6);
  ASSERT_EQ(lines->teeth.size(), combs.teeth.size());
  for (std::size_t i = 0; i < combs.teeth.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(double(lines->teeth[i][std::size_t(k)]), combs.points[i][k], 1e-6);
      EXPECT_NEAR(double(lines->teeth[i][std::size_t(k) + 3]), combs.teeth[i][k], 1e-6);
    }
  EXPECT_NEAR(lines->greatest, 1, 1e-9) << "round the tube";
  EXPECT_GE(lines->greatest, lines->typical);
}

}  // namespace
}  // namespace hariko::test

// Triangles of a surface for rays, and which surfaces are closed.

#include "core/surface/surface_triangles.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/base/parallel.hpp"
#include "core/surface/facets.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

Surface cube_facets(std::size_t left_out) {
  std::vector<Vector3> positions;
  for (int k = 0; k < 8; ++k) positions.emplace_back(k & 1, (k >> 1) & 1, (k >> 2) & 1);
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [a, b, c, d] : std::initializer_list<std::array<Index, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  triangles.resize(triangles.size() - left_out);
  const std::vector<Element> sources(triangles.size());
  return facet_surface({5, 6, 7}, positions, triangles, sources);
}

TEST(SurfaceTriangles, LieOnTheSurfaceAndLookOutward) {
  const Surface ball = test::sphere(2);
  const SurfaceTriangles parts = surface_triangles(ball, 6);
  EXPECT_EQ(parts.triangles.size(), 8U * 36);
  for (const auto& [a, b, c] : parts.triangles) {
    const Vector3 &p = parts.positions[a], &q = parts.positions[b], &r = parts.positions[c];
    EXPECT_NEAR(p.norm(), 2, 1e-12);
    EXPECT_GT((q - p).cross(r - p).dot(p + q + r), 0);
  }
}

TEST(SurfaceTriangles, AreTheSameBitsOnAnyNumberOfThreads) {
  const Surface ball = test::torus(3, 1, 24, 12);
  std::vector<Vector3> first;
  for (const int threads : {1, 2, 4}) {
    const ParallelLimit limit(threads);
    const SurfaceTriangles parts = surface_triangles(ball, 5);
    if (first.empty()) first = parts.positions;
    EXPECT_TRUE(parts.positions == first) << threads;
  }
}

TEST(SurfaceTriangles, ClosedIsWhatHasNoBorder) {
  EXPECT_TRUE(is_closed(test::sphere(1)));
  EXPECT_TRUE(is_closed(test::torus(3, 1, 6, 4)));
  EXPECT_FALSE(is_closed(Surface()));
  EXPECT_FALSE(is_closed(test::height_field(2, 2, [](Index, Index) { return test::plane(); })));
  EXPECT_FALSE(is_closed(test::height_field(1, 1, [](Index, Index) { return test::plane(); })));
  EXPECT_TRUE(is_closed(cube_facets(0)));
  EXPECT_FALSE(is_closed(cube_facets(1)));
  EXPECT_FALSE(is_closed(cube_facets(2)));
}

}  // namespace
}  // namespace hariko

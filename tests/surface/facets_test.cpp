// Facets as a surface: exact corners, flat normals.

#include "core/surface/facets.hpp"

#include <gtest/gtest.h>

namespace hariko {
namespace {

TEST(Facets, KeepCornersNormalsAndSources) {
  const std::vector<Vector3> positions{{0.1, 0, 0}, {1, 0.3, 0}, {0, 1, 0.7}, {0, 0, 5}};
  const std::vector<Element> sources{{Element::Kind::face, 4}, {Element::Kind::face, 9}};
  const Surface surface = facet_surface({7, 8, 9}, positions, {{0, 1, 2}, {0, 2, 3}}, sources);
  ASSERT_EQ(surface.patch_count(), 2U);
  EXPECT_EQ(surface.origin(), Vector3(7, 8, 9));
  EXPECT_TRUE(surface.seams().empty());
  EXPECT_EQ(surface.provenance()[1].element, sources[1]);
  const GridPattern pattern{Domain::triangle, 1};
  const std::vector<Index> both{0, 1};
  std::vector<Vector3> at(6), normals(6);
  surface.patches().evaluate_grid(both, pattern, at, normals);
  EXPECT_EQ(at[0], positions[0]);
  EXPECT_EQ(at[1], positions[1]);
  EXPECT_EQ(at[2], positions[2]);
  EXPECT_EQ(at[5], positions[3]);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(normals[std::size_t(i)].dot(positions[1] - positions[0]), 0, 1e-15);
    EXPECT_NEAR(normals[std::size_t(i)].dot(positions[2] - positions[0]), 0, 1e-15);
    EXPECT_GT(normals[std::size_t(i)].z(), 0);
  }
}

TEST(Facets, DegenerateOnesHaveNoNormal) {
  const std::vector<Vector3> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  const std::vector<Element> sources{{}};
  const Surface surface = facet_surface(Vector3::Zero(), positions, {{0, 1, 2}}, sources);
  EXPECT_TRUE(surface.normal(0, {0.3, 0.3}).isZero(0));
}

}  // namespace
}  // namespace hariko

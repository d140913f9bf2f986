#include "core/geometry/tolerant_hull.hpp"

#include <algorithm>
#include <set>

#include "core/geometry/convex_hull.hpp"
#include "tests/support/random.hpp"

namespace hariko {
namespace {

using namespace test;
using Triangle = std::array<Index, 3>;

Triangle least_first(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

TEST(TolerantHull, IsTheExactHullOfPointsInGeneralPosition) {
  for_random(5120, 60, [](std::mt19937_64& rng) {
    std::vector<Vector3> points;
    for (int i = uniform_int(rng, 8, 120); i > 0; --i)
      points.emplace_back(uniform(rng), uniform(rng), uniform(rng));
    std::set<Triangle> exact, tolerant;
    const auto hull = ConvexHull::build(points);
    ASSERT_TRUE(hull);
    for (const ConvexHull::Face& face : hull->faces())
      if (face.alive) exact.insert(least_first(face.corner));
    for (const Triangle& t : tolerant_hull(points, 1e-13).triangles) tolerant.insert(least_first(t));
    EXPECT_EQ(exact, tolerant);
  });
}

TEST(TolerantHull, LeavesOutVerticesInTheMiddleOfFacesAndEdges) {
  std::vector<Vector3> points;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z) points.emplace_back(x, y, z);
  const TolerantHull hull = tolerant_hull(points, 1e-9);
  EXPECT_EQ(hull.vertices.size(), 8U);
  EXPECT_EQ(hull.triangles.size(), 12U);
  for (const Index v : hull.vertices)
    for (const double c : points[v]) EXPECT_TRUE(c == 0 || c == 3);
  EXPECT_TRUE(tolerant_hull(std::span(points).first(16), 1e-9).triangles.empty());  // in a plane
}

}  // namespace
}  // namespace hariko

#include "core/geometry/convex_hull.hpp"

#include <set>

#include "core/geometry/orientation.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

void expect_is_hull(const ConvexHull& hull) {
  std::set<std::pair<Index, Index>> edges;
  std::size_t faces = 0;
  std::set<Index> used;
  for (Index f = 0; f < hull.faces().size(); ++f) {
    const auto& face = hull.faces()[f];
    if (!face.alive) continue;
    ++faces;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = face.corner[k], b = face.corner[(k + 1) % 3];
      used.insert(a);
      EXPECT_TRUE(edges.insert({a, b}).second) << "two faces on one side of an edge";
      const auto& beyond = hull.faces()[face.neighbour[k]];
      ASSERT_TRUE(beyond.alive);
      bool meets = false;
      for (std::size_t j = 0; j < 3; ++j) meets |= beyond.corner[j] == b && beyond.corner[(j + 1) % 3] == a;
      EXPECT_TRUE(meets) << "the neighbour does not share the edge";
    }
    for (const Vector3& point : hull.points()) EXPECT_FALSE(hull.sees(point, f));
  }
  EXPECT_EQ(faces, 2 * used.size() - 4);  // Euler
}

TEST(ConvexHull, HoldsAllRandomPoints) {
  test::for_random(9101, 40, [](std::mt19937_64& rng) {
    std::vector<Vector3> points(std::size_t(test::uniform_int(rng, 4, 120)));
    for (Vector3& point : points) point = test::random_vector(rng);
    const auto hull = ConvexHull::build(points);
    ASSERT_TRUE(hull);
    expect_is_hull(*hull);
  });
}

TEST(ConvexHull, HoldsPointsOfAGrid) {  // many in one plane, many on one line
  test::for_random(9102, 20, [](std::mt19937_64& rng) {
    std::vector<Vector3> points;
    for (int i = 0; i < 60; ++i)
      points.emplace_back(test::uniform_int(rng, 0, 1) * 8, test::uniform_int(rng, -8, 8),
                          test::uniform_int(rng, -8, 8));
    const auto hull = ConvexHull::build(points);
    if (!hull) return;
    for (Index f = 0; f < hull->faces().size(); ++f) {
      if (!hull->faces()[f].alive) continue;
      for (const Vector3& point : points) EXPECT_FALSE(hull->sees(point, f));
    }
  });
}

TEST(ConvexHull, PointsOnOneCircleOfTheSphereAreAllCorners) {
  std::vector<Vector3> points;
  for (int i = 0; i < 200; ++i) {
    const double t = 2 * 3.14159265358979 * i / 200;
    points.emplace_back(0.6 * std::cos(t), 0.6 * std::sin(t), 0.8);
  }
  points.emplace_back(0, 0, -1);
  const auto hull = ConvexHull::build(points);
  ASSERT_TRUE(hull);
  expect_is_hull(*hull);
  std::set<Index> used;
  for (const auto& face : hull->faces())
    if (face.alive) used.insert(face.corner.begin(), face.corner.end());
  EXPECT_EQ(used.size(), points.size());
}

TEST(ConvexHull, NoneOfPointsInAPlane) {
  EXPECT_FALSE(ConvexHull::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.3, 0.2, 0}}));
  EXPECT_FALSE(ConvexHull::build({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(ConvexHull::build({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}));
}

TEST(SideOfPlane, IsExactWhereRoundingIsNot) {
  // Points on a line of slope 1 far from the origin, one of them moved by the smallest step.
  const Vector3 a(12, 12, 0), b(24, 24, 0), c(0.5, 0.5, 1);
  Vector3 d(0.5, 0.5, 0);
  EXPECT_EQ(side_of_plane(a, b, c, d), 0);
  d.y() = std::nextafter(0.5, 1);
  const int above = side_of_plane(a, b, c, d);
  d.y() = std::nextafter(0.5, 0);
  EXPECT_EQ(above * side_of_plane(a, b, c, d), -1);
  test::for_random(9103, 200, [](std::mt19937_64& rng) {
    // Whole numbers, whose determinant 64 bits hold.
    std::array<Vector3, 4> p;
    for (Vector3& v : p)
      for (int k = 0; k < 3; ++k) v[k] = test::uniform_int(rng, -3, 3);
    const auto at = [&](int i, int k) { return std::int64_t(p[std::size_t(i)][k] - p[0][k]); };
    const std::int64_t exact = at(1, 0) * (at(2, 1) * at(3, 2) - at(2, 2) * at(3, 1)) -
                               at(1, 1) * (at(2, 0) * at(3, 2) - at(2, 2) * at(3, 0)) +
                               at(1, 2) * (at(2, 0) * at(3, 1) - at(2, 1) * at(3, 0));
    EXPECT_EQ(side_of_plane(p[0], p[1], p[2], p[3]), exact > 0 ? 1 : exact < 0 ? -1 : 0);
  });
}

}  // namespace
}  // namespace hariko::test

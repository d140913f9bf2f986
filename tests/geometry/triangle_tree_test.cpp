// Rays through triangles, and the side of them that points are on.

#include "core/geometry/triangle_tree.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

using Crossing = TriangleTree::Crossing;

/// Box from `low` to `high` that looks outward.
struct BoxFacets {
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;

  BoxFacets(const Vector3& low, const Vector3& high) {
    for (int k = 0; k < 8; ++k)
      positions.emplace_back(k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(),
                             k & 4 ? high.z() : low.z());
    for (const auto& [a, b, c, d] : std::initializer_list<std::array<Index, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  }
};

TEST(TriangleTree, RaysEnterAndLeaveABox) {
  for (const double size : {1e-3, 1.0, 1e6}) {
    SCOPED_TRACE(size);
    const Vector3 low = size * Vector3(1, 2, 3);
    const BoxFacets box(low, low + size * Vector3(4, 5, 6));
    const TriangleTree tree(box.positions, box.triangles);
    EXPECT_NEAR(tree.size(), size * std::sqrt(16.0 + 25 + 36), 1e-12 * size);
    const Vector3 left = low + size * Vector3(-2, 1, 1);
    EXPECT_NEAR(tree.first_crossing(left, Vector3::UnitX(), Crossing::entering), 2 * size, 1e-12 * size);
    EXPECT_NEAR(tree.first_crossing(left, Vector3::UnitX(), Crossing::leaving), 6 * size, 1e-12 * size);
    EXPECT_TRUE(std::isinf(tree.first_crossing(left, -Vector3::UnitX(), Crossing::entering)));
    EXPECT_TRUE(std::isinf(tree.first_crossing(left, Vector3::UnitY(), Crossing::leaving)));
    // Along a wall, down its edge and into its corner: the wall itself is not crossed.
    for (const Vector3& begin :
         {Vector3(low + size * Vector3(0, 1, 6)), Vector3(low + size * Vector3(0, 0, 6)),
          Vector3(low + size * Vector3(2, 5, 6))})
      EXPECT_NEAR(tree.first_crossing(begin, -Vector3::UnitZ(), Crossing::leaving), 6 * size, 1e-12 * size);
    // Hits before the ray's begin, and nearer than asked for, do not count.
    EXPECT_TRUE(std::isinf(tree.first_crossing(left, Vector3::UnitX(), Crossing::entering, 3 * size)));
  }
}

TEST(TriangleTree, RaysMeetWhatAllTrianglesSay) {
  for_random(6200, 200, [](std::mt19937_64& rng) {
    const auto point = [&] { return Vector3(uniform(rng, -1, 1), uniform(rng, -1, 1), uniform(rng, -1, 1)); };
    std::vector<Vector3> positions;
    std::vector<std::array<Index, 3>> triangles;
    for (Index t = Index(uniform_int(rng, 0, 120)); t > 0; --t) {
      const Index first = Index(positions.size());
      const Vector3 middle = point();
      for (int k = 0; k < 3; ++k) positions.push_back(middle + 0.4 * point());
      triangles.push_back({first, first + 1, first + 2});
    }
    const TriangleTree tree(positions, triangles);
    for (int ray = 0; ray < 20; ++ray) {
      const Vector3 begin = 2 * point(), direction = (point() - begin).normalized();
      for (const Crossing crossing : {Crossing::entering, Crossing::leaving}) {
        double least = std::numeric_limits<double>::infinity();
        for (const auto& [a, b, c] : triangles) {
          const Vector3 normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
          const double slope = normal.dot(direction);
          if (crossing == Crossing::leaving ? slope <= 0 : slope >= 0) continue;
          const double along = normal.dot(positions[a] - begin) / slope;
          const Vector3 at = begin + along * direction;
          const bool inside = (positions[b] - positions[a]).cross(at - positions[a]).dot(normal) >= 0 &&
                              (positions[c] - positions[b]).cross(at - positions[b]).dot(normal) >= 0 &&
                              (positions[a] - positions[c]).cross(at - positions[c]).dot(normal) >= 0;
          if (along >= 0 && inside) least = std::min(least, along);
        }
        const double found = tree.first_crossing(begin, direction, crossing);
        if (std::isinf(least)) {
          EXPECT_TRUE(std::isinf(found));
        } else {
          EXPECT_NEAR(found, least, 1e-9);
        }
      }
    }
  });
}

TEST(TriangleTree, AtASharpEdgeTheFaceSeenFromItsSideDoesNotDecide) {
  // A wedge of 20 degrees along y whose edge lies at zero: its faces look up and down, and lean back.
  const double lean = std::numbers::pi / 18;
  const Vector3 up(-std::cos(lean), 0, std::sin(lean)), down(-std::cos(lean), 0, -std::sin(lean));
  const std::vector<Vector3> positions{{0, -1, 0}, {0, 1, 0}, up, down};
  const TriangleTree tree(positions, std::vector<std::array<Index, 3>>{{0, 1, 2}, {1, 0, 3}});
  // Outside, nearest to the edge, and behind the plane of one of the faces.
  for (const Vector3& outside : {Vector3(0.3, 0, 0.15), Vector3(0.3, 0, -0.15), Vector3(0.3, 0, 0)}) {
    const auto nearest = tree.nearest(outside);
    EXPECT_NEAR(nearest.distance, outside.norm(), 1e-12);
    EXPECT_EQ(tree.side(outside, nearest), 1);
  }
  const Vector3 inside(-0.5, 0, 0.01);
  EXPECT_EQ(tree.side(inside, tree.nearest(inside)), -1);
}

TEST(ClosedTriangle, TheNearestPointLiesInTheTriangleAtTheDistance) {
  for_random(77, 300, [](std::mt19937_64& rng) {
    const double size = log_uniform(rng, 1e-3, 1e6);
    TriangleCorners corners{random_vector(rng, size), random_vector(rng, size), random_vector(rng, size)};
    if (chance(rng, 0.1)) corners[2] = corners[0] + 0.3 * (corners[1] - corners[0]);  // without area
    const ClosedTriangle triangle(corners);
    const Vector3 point = random_vector(rng, 2 * size), nearest = triangle.nearest_point(point);
    EXPECT_NEAR((nearest - point).norm(), triangle.distance(point), 1e-12 * size);
    EXPECT_LT(triangle.distance(nearest), 1e-12 * size);
    for (const Vector3& corner : corners)
      EXPECT_GE((corner - point).norm(), (nearest - point).norm() * (1 - 1e-12));
  });
}

}  // namespace
}  // namespace hariko::test

#include "core/geometry/box_tree.hpp"

#include <set>

#include "core/geometry/triangle_tree.hpp"
#include "core/geometry/winding_tree.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

using Triangle = std::array<Index, 3>;

struct Triangles {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
};

Vector3 random_point(std::mt19937_64& rng, double low, double high) {
  return {uniform(rng, low, high), uniform(rng, low, high), uniform(rng, low, high)};
}

Triangles random_triangles(std::mt19937_64& rng) {
  Triangles out;
  for (Index t = Index(uniform_int(rng, 0, 200)); t > 0; --t) {
    const Vector3 middle = random_point(rng, 0, 1);
    const Index first = Index(out.positions.size());
    for (int k = 0; k < 3; ++k) out.positions.push_back(middle + 0.1 * random_point(rng, -1, 1));
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

/// A cube of side 2 about zero.
Triangles cube() {
  Triangles out;
  for (int k = 0; k < 8; ++k) out.positions.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  for (const auto& [a, b, c, d] : std::initializer_list<std::array<Index, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    out.triangles.push_back({a, b, c});
    out.triangles.push_back({a, c, d});
  }
  return out;
}

TEST(BoxTree, HoldsEveryItemOnceInBoxesThatHoldThem) {
  for_random(6100, 100, [](std::mt19937_64& rng) {
    const Triangles mesh = random_triangles(rng);
    const Index leaf_size = Index(uniform_int(rng, 1, 9));
    const BoxTree tree = box_tree_of(mesh.positions, mesh.triangles, leaf_size);
    EXPECT_EQ(std::set<Index>(tree.order().begin(), tree.order().end()).size(), mesh.triangles.size());
    EXPECT_EQ(tree.order().size(), mesh.triangles.size());
    for (Index at = 0; at < tree.nodes().size(); ++at) {
      const BoxTree::Node& node = tree.nodes()[at];
      for (Index k = node.begin; k < node.end; ++k)
        for (const Index v : mesh.triangles[tree.order()[k]])
          EXPECT_TRUE(node.box.contains(mesh.positions[v]));
      if (node.is_leaf()) {
        EXPECT_LE(node.end - node.begin, leaf_size);
        continue;
      }
      const BoxTree::Node &left = tree.nodes()[tree.left(at)], &right = tree.nodes()[node.right];
      EXPECT_EQ(left.begin, node.begin);
      EXPECT_EQ(left.end, right.begin);
      EXPECT_EQ(right.end, node.end);
    }
  });
}

TEST(TriangleTree, FindsTheTriangleThatIsNearestOfAll) {
  for_random(6101, 100, [](std::mt19937_64& rng) {
    const Triangles mesh = random_triangles(rng);
    const TriangleTree tree(mesh.positions, mesh.triangles);
    for (int i = 0; i < 20; ++i) {
      const Vector3 point = random_point(rng, -1, 2);
      Index nearest = no_index;
      for (Index t = 0; t < mesh.triangles.size(); ++t)
        if (nearest == no_index ||
            tree.triangle(t).squared_distance(point) < tree.triangle(nearest).squared_distance(point))
          nearest = t;
      const TriangleTree::Nearest found = tree.nearest(point);
      EXPECT_EQ(found.triangle, nearest);
      if (nearest == no_index) continue;
      EXPECT_EQ(found.distance, tree.triangle(nearest).distance(point));
      EXPECT_EQ(tree.nearest(point, 0.9 * found.distance).triangle, no_index);
      EXPECT_EQ(tree.nearest(point, 1.1 * found.distance).triangle, nearest);
    }
  });
}

TEST(TriangleTree, TakesTheTriangleOfTheSmallestNumberOfSeveralAsNear) {
  const Triangles mesh = cube();
  const TriangleTree tree(mesh.positions, mesh.triangles);
  EXPECT_EQ(tree.nearest({2, 2, 2}).triangle, 2);  // the corner (1, 1, 1)
  EXPECT_DOUBLE_EQ(tree.nearest({2, 2, 2}).distance, std::sqrt(3.0));
}

TEST(WindingTree, CountsTurnsAndMeasuresDistancesAsTheTriangleTreeDoes) {
  const Triangles mesh = cube();
  const WindingTree winding(mesh.positions, mesh.triangles);
  const TriangleTree nearest(mesh.positions, mesh.triangles);
  for_random(6102, 500, [&](std::mt19937_64& rng) {
    const Vector3 point = random_point(rng, -2, 2);
    const double out = point.cwiseAbs().maxCoeff() - 1;
    if (std::abs(out) < 1e-3) return;
    EXPECT_NEAR(winding.winding(point), out < 0 ? 1 : 0, 0.02);
    const double distance = nearest.nearest(point).distance;
    EXPECT_NEAR(winding.nearest(point).distance, distance, 1e-14);
    EXPECT_TRUE(winding.is_clear(point, 0.999 * distance));
    EXPECT_FALSE(winding.is_clear(point, 1.001 * distance));
  });
}

}  // namespace
}  // namespace hariko::test

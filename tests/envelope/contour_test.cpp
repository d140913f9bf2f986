// Meshes over cubes of several sizes are closed, whatever cubes are halved.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/base/equal_bits.hpp"
#include "core/envelope/ball/ball_cage.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {

namespace {

constexpr int base = 6;

/// The distance to a ball, less what makes it uneven.
SplineField ball_field(double radius, double bumps) {
  constexpr int nodes = 49;
  constexpr double spacing = double(base) / (nodes - 1);
  std::vector<double> weights;
  for (int k = 0; k < nodes; ++k)
    for (int j = 0; j < nodes; ++j)
      for (int i = 0; i < nodes; ++i) {
        const Vector3 p = spacing * Vector3(i, j, k) - Vector3::Constant(0.5 * base + 0.013);
        weights.push_back(p.norm() - radius - bumps * std::sin(5 * p.x()) * std::sin(4 * p.y()));
      }
  return {Vector3::Zero(), spacing, {nodes, nodes, nodes}, std::move(weights)};
}

CubeTree random_cubes(std::mt19937_64& rng, int splits) {
  CubeTree out(Vector3::Zero(), {base, base, base}, 1, 3);
  for (int k = 0; k < splits; ++k) {
    const int level = uniform_int(rng, 0, 2), last = (base << level) - 1;
    out.split({level, {uniform_int(rng, 0, last), uniform_int(rng, 0, last), uniform_int(rng, 0, last)}});
  }
  return out;
}

}  // namespace

TEST(CubeTree, CubesThatTouchDifferByOneLevelAtMost) {
  for_random(5, 10, [](std::mt19937_64& rng) {
    const CubeTree cubes = random_cubes(rng, 12);
    const int end = base << cubes.depth();
    for (int k = 0; k < 4000; ++k) {
      std::array<int, 3> at, beside;
      for (std::size_t a = 0; a < 3; ++a) {
        at[a] = uniform_int(rng, 1, end - 2);
        beside[a] = at[a] + uniform_int(rng, -1, 1);
      }
      EXPECT_LE(std::abs(cubes.leaf(at).level - cubes.leaf(beside).level), 1);
    }
  });
}

TEST(Contour, IsTheSameWithValuesKeptByTheCubes) {
  const SplineField field = ball_field(2, 0);
  const CubeTree keeping = surface_cubes(field, Vector3::Zero(), 1);
  ASSERT_FALSE(keeping.any_split());
  const int half = keeping.steps(0) / 2;
  int known = 0;
  for (int k = 0; k <= 2 * keeping.size()[2]; ++k)
    for (int j = 0; j <= 2 * keeping.size()[1]; ++j)
      for (int i = 0; i <= 2 * keeping.size()[0]; ++i) {
        const std::array<int, 3> node{half * i, half * j, half * k};
        const double kept = keeping.known_value(node);
        if (std::isnan(kept)) continue;
        ++known;
        ASSERT_TRUE(equal_bits(kept, field.value(keeping.point(node))));
      }
  EXPECT_GT(known, 0);
  EXPECT_TRUE(std::isnan(keeping.known_value({half + 1, half, half})));
  const CubeTree plain(keeping.point({0, 0, 0}), keeping.size(), 1, keeping.depth());
  const Contour one = contour(keeping, field), other = contour(plain, field);
  EXPECT_EQ(one.faces, other.faces);
  ASSERT_EQ(one.vertices.size(), other.vertices.size());
  for (std::size_t v = 0; v < one.vertices.size(); ++v)
    ASSERT_TRUE(equal_bits(one.vertices[v].position, other.vertices[v].position)) << v;
}

TEST(Contour, IsClosedOverCubesOfSeveralSizes) {
  for_random(6, 12, [](std::mt19937_64& rng) {
    const SplineField field = ball_field(uniform(rng, 0.6, 2), 0.15);
    const Contour mesh = contour(random_cubes(rng, uniform_int(rng, 0, 14)), field);
    ASSERT_FALSE(mesh.faces.empty());
    std::map<std::pair<Index, Index>, int> sides;
    for (const auto& face : mesh.faces) {
      const std::size_t n = face[3] == no_index ? 3 : 4;
      for (std::size_t i = 0; i < n; ++i) {
        ASSERT_LT(face[i], mesh.vertices.size());
        ++sides[{face[i], face[(i + 1) % n]}];
      }
    }
    // Two faces may share two sides where a vertex has no third one.
    for (const auto& [ends, uses] : sides) {
      const auto back = sides.find({ends.second, ends.first});
      ASSERT_NE(back, sides.end());
      EXPECT_EQ(uses, back->second);
    }
    for (const ContourVertex& vertex : mesh.vertices) {
      EXPECT_GE(vertex.faces, 2);
      EXPECT_LE(std::abs(field.value(vertex.position)), 1) << "the edge of the largest cubes";
    }
  });
}

}  // namespace hariko::test

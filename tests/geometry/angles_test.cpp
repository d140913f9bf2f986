// Angles between directions and keys of edges, against what defines them.

#include "core/geometry/angles.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <set>

#include "core/geometry/edge_key.hpp"

namespace hariko {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Angles, ATurnAboutAnAxisIsFoundAgainWhateverTheLengthsAre) {
  const unsigned seed = 3911;
  RecordProperty("seed", int(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 500; ++round) {
    const Vector3 axis = Vector3(uniform(random), uniform(random), uniform(random)).normalized();
    const Vector3 a = axis.unitOrthogonal() * std::exp(3 * uniform(random));
    const double turn = pi * uniform(random);
    const Vector3 b = std::exp(3 * uniform(random)) * (Eigen::AngleAxisd(turn, axis) * a);
    EXPECT_NEAR(angle_between(a, b), std::abs(turn), 1e-14) << "seed " << seed;
    EXPECT_NEAR(signed_angle(a, b, axis), turn, 1e-14) << "seed " << seed;
    EXPECT_NEAR(signed_angle(b, a, axis), -turn, 1e-14) << "seed " << seed;
  }
}

TEST(Angles, AngleBetweenIsAccurateForTinyAnglesAndZeroForAZeroVector) {
  for (const double turn : {1e-3, 1e-8, 1e-12, 1e-150})
    EXPECT_NEAR(angle_between(Vector3(2, 0, 0), Vector3(3, 3 * turn, 0)), std::atan(turn), 1e-15 * turn);
  EXPECT_NEAR(angle_between(Vector3(1, 0, 0), Vector3(-1, 1e-9, 0)), pi - 1e-9, 1e-15);
  EXPECT_EQ(angle_between(Vector3::Zero(), Vector3(1, 2, 3)), 0);
  EXPECT_EQ(angle_between(Vector3(1, 2, 3), Vector3::Zero()), 0);
}

TEST(EdgeKey, KeysTellEdgesApartAndGiveTheirEndsBack) {
  const std::vector<Index> vertices{0, 1, 2, 77, 0x7fffffffU, 0x80000000U, 0xfffffffeU};
  std::set<std::uint64_t> half_edges, edges;
  for (const Index a : vertices)
    for (const Index b : vertices) {
      if (a == b) continue;
      const auto [from, to] = ends_of_key(half_edge_key(a, b));
      EXPECT_EQ(from, a);
      EXPECT_EQ(to, b);
      EXPECT_EQ(edge_key(a, b), edge_key(b, a));
      half_edges.insert(half_edge_key(a, b));
      edges.insert(edge_key(a, b));
    }
  EXPECT_EQ(half_edges.size(), vertices.size() * (vertices.size() - 1));
  EXPECT_EQ(edges.size(), half_edges.size() / 2);
}

}  // namespace
}  // namespace hariko

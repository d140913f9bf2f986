#include "core/surface/tessellation.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/base/parallel.hpp"
#include "tests/support/analytic_patches.hpp"

namespace hariko {
namespace {

struct Edges {
  std::set<std::pair<Index, Index>> directed;
  std::size_t unpaired = 0, undirected = 0;
};

/// Fails the test when a directed edge is used twice.
Edges edges_of(const TriangleMesh& mesh) {
  Edges out;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NE(t[k], t[(k + 1) % 3]);
      EXPECT_TRUE(out.directed.insert({t[k], t[(k + 1) % 3]}).second) << "a directed edge is used twice";
    }
  for (const auto& [a, b] : out.directed) {
    const bool paired = out.directed.count({b, a}) > 0;
    out.unpaired += paired ? 0 : 1;
    out.undirected += !paired || a < b ? 1 : 0;
  }
  return out;
}

long euler(const TriangleMesh& mesh) {
  return long(mesh.positions.size()) - long(edges_of(mesh).undirected) + long(mesh.triangles.size());
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
  return sum;
}

TEST(Tessellation, SphereIsClosedAndRound) {
  const Surface surface = test::sphere(2);
  for (const int density : {1, 2, 3, 8, 17}) {
    const TriangleMesh mesh = tessellate(surface, density);
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(8 * density * density));
    EXPECT_EQ(edges_of(mesh).unpaired, 0U);
    EXPECT_EQ(euler(mesh), 2);
    ASSERT_EQ(mesh.normal_triangles.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size()) << "every normal of a smooth surface is shared";
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3& p = mesh.positions[mesh.triangles[t][k]];
        EXPECT_NEAR(p.norm(), 2, 1e-14);
        EXPECT_TRUE(mesh.normals[mesh.normal_triangles[t][k]].isApprox(p / 2, 1e-13));
      }
  }
  EXPECT_NEAR(volume(tessellate(surface, 64)), 32 * std::numbers::pi / 3, 0.02);
}

TEST(Tessellation, TorusHasEulerNumberZero) {
  const TriangleMesh mesh = tessellate(test::torus(3, 1, 5, 3), 6);
  EXPECT_EQ(edges_of(mesh).unpaired, 0U);
  EXPECT_EQ(euler(mesh), 0);
  EXPECT_EQ(mesh.triangles.size(), 15U * 72U);
  EXPECT_GT(volume(mesh), 0);
}

TEST(Tessellation, OpenFieldHasItsBorder) {
  const Surface surface = test::height_field(3, 2, [](Index, Index) { return test::saddle(); });
  const int density = 5;
  const TriangleMesh mesh = tessellate(surface, density);
  const Edges edges = edges_of(mesh);
  EXPECT_EQ(edges.unpaired, 10U * density);
  EXPECT_EQ(euler(mesh), 1);
  // The border is one loop: each border point is left once and entered once.
  std::map<Index, Index> next;
  for (const auto& [a, b] : edges.directed)
    if (!edges.directed.count({b, a})) {
      EXPECT_TRUE(next.emplace(a, b).second);
    }
  std::size_t length = 0;
  Index at = next.begin()->first;
  do {
    at = next.at(at);
    ++length;
  } while (at != next.begin()->first && length <= next.size());
  EXPECT_EQ(length, 10U * density);
}

TEST(Tessellation, NormalsAreSplitAcrossCreasesOnly) {
  const auto roof = [](Index i, Index) { return test::plane(i == 0 ? 1.0 : -1.0, 0, i == 0 ? 0.0 : 2.0); };
  test::AnalyticOptions sharp;
  sharp.continuity = Continuity::g0;
  const int density = 4;
  const TriangleMesh split = tessellate(test::height_field(2, 1, roof, sharp), density);
  EXPECT_EQ(split.positions.size(), 45U);
  EXPECT_EQ(split.normals.size(), 50U);
  const TriangleMesh shared = tessellate(test::height_field(2, 1, roof), density);
  EXPECT_EQ(shared.normals.size(), 45U);
  const double h = std::sqrt(0.5);
  for (std::size_t t = 0; t < split.triangles.size(); ++t) {
    const Vector3 expected = t < split.triangles.size() / 2 ? Vector3(-h, 0, h) : Vector3(h, 0, h);
    for (const Index n : split.normal_triangles[t]) EXPECT_TRUE(split.normals[n].isApprox(expected, 1e-14));
  }
}

TEST(Tessellation, NodeNormalReplacesADegenerateCorner) {
  // At s = 0 the whole side shrinks to a point: ds x dt vanishes there.
  const auto fan = [](double s, double t) {
    PatchPoint p;
    p.position = {s, s * t, 0};
    p.ds = {1, t, 0};
    p.dt = {0, s, 0};
    return p;
  };
  test::AnalyticOptions options;
  options.node_normals.assign(4, Vector3::Zero());
  options.node_normals[0] = options.node_normals[3] = Vector3::UnitZ();
  const TriangleMesh mesh = tessellate(test::make_surface(Domain::square, {fan}, {0, 1, 2, 3}, options), 4);
  for (const Vector3& n : mesh.normals) EXPECT_TRUE(n.isApprox(Vector3::UnitZ(), 1e-12)) << n.transpose();
}

TEST(Tessellation, IsTheSameOnAnyNumberOfThreads) {
  const Surface surface = test::torus(3, 1, 9, 7);
  const TriangleMesh many = tessellate(surface, 7);
  const ParallelLimit one(1);
  const TriangleMesh single = tessellate(surface, 7);
  EXPECT_EQ(many.positions, single.positions);
  EXPECT_EQ(many.normals, single.normals);
  EXPECT_EQ(many.triangles, single.triangles);
}

TEST(Tessellation, KeepsTheOriginAndStopsWhenCancelled) {
  test::AnalyticOptions options;
  options.origin = {1e6, -2e6, 3e6};
  EXPECT_EQ(tessellate(test::sphere(1, options), 3).origin, options.origin);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_TRUE(tessellate(test::sphere(1), 3, cancel).triangles.empty());
  EXPECT_TRUE(tessellate(Surface(), 3).triangles.empty());
}

}  // namespace
}  // namespace hariko

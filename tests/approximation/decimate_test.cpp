// Decimation of dense meshes, checked by dense samples in both directions without the code under test.

#include "core/approximation/decimation/decimate.hpp"

#include <numbers>

#include "core/approximation/hausdorff_bound.hpp"
#include "core/base/parallel.hpp"
#include "core/surface/weld_patches.hpp"
#include "tests/approximation/checker.hpp"
#include "tests/approximation/meshes.hpp"
#include "tests/approximation/surfaces.hpp"

namespace hariko::test {
namespace {

/// The largest distance of points on the triangles of `from` to those of `to`.
double farthest(const TriangleMesh& from, const TriangleMesh& to, int density) {
  const TriangleGrid grid(to.positions, to.triangles);
  double worst = 0;
  for (const auto& t : from.triangles)
    for (int i = 0; i <= density; ++i)
      for (int j = 0; j <= density - i; ++j) {
        const double a = double(i) / density, b = double(j) / density;
        worst = std::max(worst, grid.distance((1 - a - b) * from.positions[t[0]] + a * from.positions[t[1]] +
                                              b * from.positions[t[2]]));
      }
  return worst;
}

/// Edges by the number of facets in each direction.
std::map<std::pair<Index, Index>, std::array<int, 2>> edges_of(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, std::array<int, 2>> out;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++out[std::minmax(t[k], t[(k + 1) % 3])][t[k] < t[(k + 1) % 3] ? 0 : 1];
  return out;
}

void expect_manifold(const TriangleMesh& mesh, bool closed) {
  for (const auto& [edge, uses] : edges_of(mesh)) {
    EXPECT_LE(uses[0], 1);
    EXPECT_LE(uses[1], 1);
    if (closed) {
      EXPECT_EQ(uses[0] + uses[1], 2);
    }
  }
}

TriangleMesh without_normals(TriangleMesh mesh) {
  mesh.normals.clear();
  mesh.normal_triangles.clear();
  return mesh;
}

/// A cube of side 2 with `n` x `n` squares a side.
TriangleMesh dense_cube(int n) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> numbers;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, fresh] = numbers.try_emplace(at, Index(mesh.positions.size()));
    if (fresh) mesh.positions.emplace_back(2.0 * at[0] / n - 1, 2.0 * at[1] / n - 1, 2.0 * at[2] / n - 1);
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int side : {0, n})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          std::array<Index, 4> v;
          for (int k = 0; k < 4; ++k) {
            std::array<int, 3> at;
            at[axis] = side;
            at[(axis + 1) % 3] = i + (k == 1 || k == 2);
            at[(axis + 2) % 3] = j + (k >= 2);
            v[std::size_t(k)] = vertex(at);
          }
          if (side == 0) std::swap(v[1], v[3]);
          mesh.triangles.push_back({v[0], v[1], v[2]});
          mesh.triangles.push_back({v[0], v[2], v[3]});
        }
  return mesh;
}

TEST(MeshBound, IsAboveEverySampleAndTightEnough) {
  for_random(61, 10, [](std::mt19937_64& rng) {
    // Two height fields over the same square, on different grids.
    const auto field = [&](int n, double height) {
      TriangleMesh mesh;
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          mesh.positions.emplace_back(double(i) / n, double(j) / n, uniform(rng, -height, height));
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const Index a = Index(j * (n + 1) + i), b = a + 1, c = b + Index(n) + 1, d = c - 1;
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
      return mesh;
    };
    const int cells = uniform_int(rng, 2, 12);
    const TriangleMesh a = field(cells, 0.03), b = field(uniform_int(rng, 2, 12), 0.03);
    const TriangleTree tree(b.positions, b.triangles);
    // Samples as dense on few facets as on many. A distance changes by no more than the way that it is from
    // the nearest sample.
    const int density = 288 / cells;
    const double sampled = farthest(a, b, density);
    const double between = std::sqrt(2.0 + 0.06 * 0.06 * cells * cells) / (cells * density * std::sqrt(3.0));
    const auto within = [&](double tolerance) {
      return bounded_distance(a.positions, a.triangles, tree, b.positions, b.triangles, tolerance);
    };
    EXPECT_FALSE(within(sampled * 0.999).bound.has_value());
    const MeshBound bound = within(sampled * 1.05 + between);
    ASSERT_TRUE(bound.bound.has_value());
    EXPECT_GE(*bound.bound, sampled * (1 - 1e-12));
    EXPECT_LE(*bound.bound, sampled * 1.05 + between);
  });
}

TEST(Decimate, ACubeBecomesTwelveTriangles) {
  const TriangleMesh dense = dense_cube(12);
  for (const double tolerance : {1e-5, 0.01}) {
    const auto made = must(decimate(dense, by_distance(tolerance)));
    EXPECT_EQ(made->mesh.triangles.size(), 12U);
    EXPECT_TRUE(made->distance.certified);
    EXPECT_LE(made->distance.bound, tolerance);
    expect_manifold(made->mesh, true);
    EXPECT_LE(farthest(dense, made->mesh, 3), tolerance);
    EXPECT_LE(farthest(made->mesh, dense, 20), tolerance);
  }
}

TEST(Decimate, TheToleranceHoldsBothWays) {
  for (const char* name : {"wave", "fender", "pair"}) {
    SCOPED_TRACE(name);
    const Surface surface = golden_surface(name);
    const TriangleMesh dense = without_normals(tessellate(surface, repetitions(1) > 1 ? 40 : 20));
    for (const double tolerance : {0.05, 0.02}) {
      const auto made = must(decimate(dense, by_distance(tolerance)));
      EXPECT_LT(made->mesh.triangles.size(), dense.triangles.size() / 3);
      EXPECT_TRUE(made->distance.certified);
      EXPECT_LE(made->distance.bound, tolerance);
      EXPECT_LE(made->distance.largest, made->distance.bound);
      expect_manifold(made->mesh, false);
      EXPECT_LE(farthest(dense, made->mesh, 3), tolerance);
      EXPECT_LE(farthest(made->mesh, dense, 16), tolerance);
      // Every vertex is one of the dense mesh.
      for (const Vector3& p : made->mesh.positions)
        EXPECT_NE(std::find(dense.positions.begin(), dense.positions.end(), p), dense.positions.end());
    }
  }
}

TEST(Decimate, ClosedMeshesStayClosed) {
  const Surface surface = weld_patches(Vector3::Zero(), rational_sphere(1)).value();
  const TriangleMesh dense = without_normals(approximate(surface, by_distance(0.002))->mesh);
  expect_manifold(dense, true);
  const auto made = must(decimate(dense, by_distance(0.02)));
  EXPECT_LT(made->mesh.triangles.size(), 450U);
  expect_manifold(made->mesh, true);
  EXPECT_LE(farthest(dense, made->mesh, 2), 0.02);
  EXPECT_LE(farthest(made->mesh, dense, 10), 0.02);
}

TEST(Decimate, OtherCriteriaHold) {
  const Surface surface = golden_surface("wave");
  const TriangleMesh dense = without_normals(tessellate(surface, 40));
  MeshOptions options = by_distance(0.2);
  const std::size_t by_distance_alone = decimate(dense, options)->mesh.triangles.size();
  options.criteria.normal_angle = 12 * degrees;
  options.criteria.max_edge = 0.8;
  const auto made = must(decimate(dense, options));
  EXPECT_GT(made->mesh.triangles.size(), by_distance_alone);
  EXPECT_LE(made->longest_edge, 0.8);
  double longest = 0;
  for (const auto& [edge, uses] : edges_of(made->mesh))
    longest =
        std::max(longest, (made->mesh.positions[edge.first] - made->mesh.positions[edge.second]).norm());
  EXPECT_LE(longest, 0.8);
  MeshOptions folds;
  folds.criteria.fold_angle = 15 * degrees;
  const auto folded = must(decimate(dense, folds));
  EXPECT_LT(folded->mesh.triangles.size(), dense.triangles.size() / 2);
  EXPECT_LE(folded->fold_angle.largest, 15 * degrees);
  EXPECT_FALSE(folded->distance.certified);
}

TEST(Decimate, WhatIsNotManifoldStays) {
  // Three squares that share an edge, each of 8 x 8 cells.
  TriangleMesh mesh;
  std::map<std::array<int, 3>, Index> numbers;
  constexpr int n = 8;
  const auto vertex = [&](int sheet, int i, int j) {
    const auto [found, fresh] = numbers.try_emplace({i == 0 ? 0 : sheet, i, j}, Index(mesh.positions.size()));
    const double angle = 120 * degrees * sheet, r = double(i) / n;
    if (fresh) mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), double(j) / n);
    return found->second;
  };
  for (int sheet = 0; sheet < 3; ++sheet)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Index a = vertex(sheet, i, j), b = vertex(sheet, i + 1, j), c = vertex(sheet, i + 1, j + 1),
                    d = vertex(sheet, i, j + 1);
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
      }
  // One triangle with two equal corners, and a vertex that nothing uses.
  mesh.triangles.push_back({0, 0, 1});
  mesh.positions.emplace_back(5, 5, 5);
  const auto made = must(decimate(mesh, by_distance(0.01)));
  EXPECT_LT(made->mesh.triangles.size(), 60U);
  std::size_t of_three = 0;
  for (const auto& [edge, uses] : edges_of(made->mesh)) of_three += uses[0] + uses[1] == 3;
  EXPECT_EQ(of_three, std::size_t(n));
}

TEST(Decimate, SameOnAnyNumberOfThreadsAndScale) {
  const Surface surface = golden_surface("fender");
  const TriangleMesh dense = without_normals(tessellate(surface, 24));
  std::vector<MeshApproximation> made;
  for (const int threads : {1, 2}) {
    const ParallelLimit limit(threads);
    made.push_back(decimate(dense, by_distance(0.02)).value());
  }
  EXPECT_EQ(made[0].mesh.triangles, made[1].mesh.triangles);
  TriangleMesh large = dense;
  for (Vector3& p : large.positions) p *= 1024;
  EXPECT_EQ(decimate(large, by_distance(0.02 * 1024))->mesh.triangles, made[0].mesh.triangles);
}

TEST(Decimate, RefusalsAndCancel) {
  EXPECT_EQ(decimate({}, by_distance(1)).error().code, e_mesh_nothing);
  const TriangleMesh cube = dense_cube(3);
  EXPECT_EQ(decimate(cube, {}).error().code, e_mesh_nothing);
  EXPECT_EQ(decimate(cube, by_distance(-1)).error().code, e_mesh_tolerance);
  TriangleMesh point = cube;
  for (Vector3& p : point.positions) p = Vector3(1, 2, 3);
  EXPECT_EQ(decimate(point, by_distance(1)).error().code, e_mesh_surface);
  const CancelToken cancel = CancelToken::make();
  cancel.cancel();
  EXPECT_EQ(decimate(cube, by_distance(0.01), cancel).error().code, e_cancelled);
}

}  // namespace
}  // namespace hariko::test

// The mode position (gaussmap.md 8).

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>

#include "core/gaussmap/lloyd_relaxed_mesh.hpp"
#include "core/gaussmap/position_mesh.hpp"
#include "tests/gaussmap/truths.hpp"
#include "tests/support/random.hpp"

namespace hariko::test {
namespace {

double distance(const GroundTruth& truth) {
  GaussOptions options = in_mode(GaussMode::position);
  const auto points = must(control_points(truth.outline, options));
  const PointErrors errors = point_errors(*points, truth.truth);
  if (std::getenv("HARIKO_SHOW_NUMBERS")) {
    std::ostringstream line;
    line << std::scientific << std::setprecision(1) << "position | " << truth.name << " | "
         << points->boundary_count << " / " << points->points.size() - points->boundary_count << " | d "
         << errors.distance << " | " << points->iterations << " iterations";
    std::cout << line.str() << std::endl;
  }
  for (const Message& message : points->messages)
    EXPECT_EQ(message.code, w_normal_tangent)
        << to_string(message);  // coarse loops have chords that are not tangents
  return errors.distance;
}

TEST(PositionMode, ConvergesOnTheCatenoid) {
  EXPECT_LE(distance(catenoid_strip(16)), 1.25 * 1.5e-2);
  EXPECT_LE(distance(catenoid_strip(32)), 1.25 * 3.7e-3);
  EXPECT_LE(distance(catenoid_strip(64)), 1.25 * 9.2e-4);
}

TEST(PositionMode, ConvergesOnTheSaddle) {
  EXPECT_LE(distance(saddle_disc(16)), 1.25 * 4.0e-3);
  EXPECT_LE(distance(saddle_disc(32)), 1.25 * 1.8e-3);
  EXPECT_LE(distance(saddle_disc(64)), 1.25 * 1.2e-3);
}

/// Each edge has one triangle on its left, and none on its right along the loops.
void expect_manifold(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Index>& next) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(edges.insert({triangle[k], triangle[(k + 1) % 3]}).second);
  for (const auto& [a, b] : edges) {
    const bool loop = a < next.size() && next[a] == b;
    EXPECT_EQ(edges.contains({b, a}), !loop) << a << " " << b;
  }
  for (Index i = 0; i < next.size(); ++i) EXPECT_TRUE(edges.contains({i, next[i]}));
}

TEST(PositionMode, MeshesAreManifoldWithTheLoopsAsTheirBorder) {
  for (const std::size_t count : {8u, 16u, 37u}) {
    for (const GroundTruth& truth : {catenoid_strip(count), saddle_disc(count), sphere_band(count)}) {
      SCOPED_TRACE(truth.name);
      const auto mesh = must(position_mesh(truth.outline, 0.6, 20000));
      expect_manifold(mesh->triangles, mesh->next);
    }
  }
}

/// Mean over the triangles of what their areas lack of that of an equilateral one with sides of the same root
/// mean square: 0 for equilateral triangles, 1 for those without an area.
double raggedness(const std::vector<Vector3>& points, const std::vector<std::array<Index, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vector3 u = points[b] - points[a], v = points[c] - points[a];
    const double squares = u.squaredNorm() + v.squaredNorm() + (v - u).squaredNorm();
    sum += 1 - 2 * std::sqrt(3) * u.cross(v).norm() / squares;
  }
  return sum / double(triangles.size());
}

std::vector<Index> next_of(const Outline& outline) {
  std::vector<Index> out;
  for (const OutlineLoop& loop : outline.loops) {
    const auto first = Index(out.size()), count = Index(loop.points.size());
    for (Index i = 0; i < count; ++i) out.push_back(first + (i + 1) % count);
  }
  return out;
}

TEST(PositionMode, VerticesAreSpreadEvenlyOverTheShape) {
  // A cap whose sides stand up steeply: even in its layout it is not even in space.
  for (const GroundTruth& truth : {sphere_cap(32), saddle_disc(32), ellipsoid_cap(32)}) {
    SCOPED_TRACE(truth.name);
    GaussOptions options = in_mode(GaussMode::position);
    const auto even = must(control_points(truth.outline, options));
    options.relaxation = 0;
    const auto ragged = must(control_points(truth.outline, options));
    ASSERT_EQ(even->points.size(), ragged->points.size());
    EXPECT_EQ(even->triangles.size(), ragged->triangles.size());
    expect_manifold(even->triangles, next_of(truth.outline));
    const double before = raggedness(ragged->points, ragged->triangles),
                 after = raggedness(even->points, even->triangles);
    if (std::getenv("HARIKO_SHOW_NUMBERS"))
      std::cout << "raggedness | " << truth.name << " | " << before << " -> " << after << std::endl;
    EXPECT_LT(after, 0.75 * before);
  }
}

TEST(PositionMode, FoldedImagesAndMixedCurvatureWork) {
  // A wavy loop over the plane, whose normals all but stay upright: the Gauss image crosses itself.
  OutlineLoop loop;
  for (int i = 0; i < 48; ++i) {
    const double t = 2 * pi * i / 48, x = std::cos(t), y = std::sin(t);
    // z = 0.2 cos(3 t) r^3: the monkey saddle
    const double fx = 0.6 * (x * x - y * y), fy = -1.2 * x * y;
    loop.points.emplace_back(x, y, 0.2 * (x * x * x - 3 * x * y * y));
    loop.normals.push_back(Vector3(-fx, -fy, 1).normalized());
  }
  GaussOptions options;
  EXPECT_FALSE(control_points({{loop}}, options).ok());
  options.mode = GaussMode::position;
  const auto points = must(control_points({{loop}}, options));
  double largest = 0;
  for (Index i = points->boundary_count; i < points->points.size(); ++i) {
    const Vector3& p = points->points[i];
    largest = std::max(largest, std::abs(p.z() - 0.2 * (std::pow(p.x(), 3) - 3 * p.x() * p.y() * p.y())));
  }
  EXPECT_LE(largest, 2e-2);
}

TEST(PositionMode, SpreadingKeepsTheLoopsAndTheMeshWhole) {
  for_random(9604, 12, [](std::mt19937_64& rng) {
    const GroundTruth truth = rng() % 2 ? saddle_disc(std::size_t(uniform_int(rng, 8, 40)))
                                        : catenoid_strip(std::size_t(uniform_int(rng, 8, 40)));
    PositionMesh mesh = *position_mesh(truth.outline, uniform(rng, 0.3, 1), 20000);
    // Anywhere: what is folded stays so, but nothing is torn.
    if (rng() % 2)
      for (std::size_t i = mesh.boundary_count; i < mesh.points.size(); ++i)
        mesh.points[i] += random_vector(rng, 0.1);
    const PositionMesh before = mesh;
    spread_evenly(mesh, uniform_int(rng, 1, 12));
    ASSERT_EQ(mesh.triangles.size(), before.triangles.size());
    expect_manifold(mesh.triangles, mesh.next);
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      ASSERT_TRUE(mesh.points[i].allFinite());
      if (i < mesh.boundary_count) {
        EXPECT_EQ(mesh.points[i], before.points[i]);
      }
    }
    PositionMesh again = before;
    spread_evenly(again, 0);  // flips alone
    EXPECT_EQ(again.points, before.points);
  });
}

TEST(PositionMode, LoopsBesideEachOtherHaveNoLayout) {
  Outline outline;
  for (int l = 0; l < 3; ++l) {
    OutlineLoop& loop = outline.loops.emplace_back();
    for (int i = 0; i < 12; ++i) {
      const double t = 2 * pi * i / 12;
      loop.points.emplace_back(std::cos(t) + 4 * l, std::sin(t), 0);
      loop.normals.push_back(Vector3(std::cos(t), std::sin(t), 3).normalized());
    }
  }
  GaussOptions options = in_mode(GaussMode::position);
  must_fail(control_points(outline, options), e_no_layout);
}

}  // namespace
}  // namespace hariko::test

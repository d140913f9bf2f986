// Bodies that touch, faces with holes, cavities: what repairs and readers make of them.

#include <algorithm>
#include <numeric>

#include "core/polyhedron/join_corners.hpp"
#include "core/polyhedron/repair.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

/// Mesh in which vertices at equal positions are one.
PolygonMesh shared(const PolygonMesh& mesh) {
  return weld(mesh, 0);
}

/// Volumes of the closed parts of a sound mesh without borders, ascending; empty otherwise.
std::vector<double> volumes_of(const PolygonMesh& mesh) {
  const auto topology = HalfEdgeMesh::build(mesh);
  if (!topology.ok() || topology->border_loop_count() > 0) return {};
  std::vector<double> out = closed_component_volumes(*topology, mesh.positions);
  std::sort(out.begin(), out.end());
  return out;
}

/// Extents of `cube()` along the axes.
Vector3 extent_of_cube() {
  Vector3 low = cube().positions[0], high = low;
  for (const Vector3& p : cube().positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return high - low;
}

PolygonMesh inside_out(const PolygonMesh& mesh) {
  PolygonMesh out;
  out.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    out.add_face(std::vector<Index>(mesh.face(f).rbegin(), mesh.face(f).rend()));
  return out;
}

PolygonMesh scaled(PolygonMesh mesh, double factor) {
  for (Vector3& p : mesh.positions) p *= factor;
  return mesh;
}

TEST(SeparateBodies, CubesThatTouchInAPointAnEdgeOrAFaceStayTwo) {
  const Vector3 size = extent_of_cube();
  const double volume = size.prod();
  for (const Vector3& step : {Vector3(1, 1, 1), Vector3(1, 1, 0), Vector3(0, 1, -1), Vector3(1, 0, 0)}) {
    const PolygonMesh touching = shared(together(cube(), cube(), step.cwiseProduct(size)));
    ASSERT_FALSE(HalfEdgeMesh::build(touching).ok()) << step.transpose();
    const auto apart = separate_bodies(touching);
    ASSERT_TRUE(apart.has_value()) << step.transpose();
    const std::vector<double> volumes = volumes_of(apart->mesh);
    ASSERT_EQ(volumes.size(), 2U) << step.transpose();
    for (const double each : volumes) EXPECT_NEAR(each, volume, 1e-12 * volume);
    ASSERT_EQ(apart->original.size(), apart->mesh.positions.size());
    for (std::size_t v = 0; v < apart->original.size(); ++v)
      EXPECT_EQ(apart->mesh.positions[v], touching.positions[apart->original[v]]);
    // The repair does the same, though it merges vertices first.
    const auto repaired = must(make_manifold(touching));
    EXPECT_EQ(volumes_of(repaired->mesh).size(), 2U) << step.transpose();
  }
}

TEST(SeparateBodies, RowsOfCubesInAnyOrderStayApart) {
  for_random(781, 60, [](std::mt19937_64& rng) {
    const Vector3 size = extent_of_cube();
    PolygonMesh row = cube();
    Vector3 at = Vector3::Zero();
    const int count = uniform_int(rng, 2, 5);
    for (int k = 1; k < count; ++k) {
      at += Vector3(size.x(), chance(rng, 0.5) ? size.y() : 0, chance(rng, 0.5) ? size.z() : 0);
      row = together(row, cube(), at);
    }
    row = shared(row);
    std::vector<Index> order(row.face_count());
    std::iota(order.begin(), order.end(), Index{0});
    std::shuffle(order.begin(), order.end(), rng);
    PolygonMesh mixed;
    mixed.positions = row.positions;
    for (const Index f : order) mixed.add_face(row.face(f));
    const auto apart = separate_bodies(mixed);
    ASSERT_TRUE(apart.has_value());
    EXPECT_EQ(volumes_of(apart->mesh).size(), std::size_t(count));
  });
}

TEST(SeparateBodies, NothingIsMadeOfSheetsDoublesAndSoundMeshes) {
  EXPECT_FALSE(separate_bodies(cube()).has_value());
  PolygonMesh wings;
  wings.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (const Index tip : {2U, 4U}) wings.add_face({0, 1, tip});
  for (const Index tip : {3U, 5U}) wings.add_face({1, 0, tip});
  EXPECT_FALSE(separate_bodies(wings).has_value()) << "two folds that touch along an edge are no bodies";
  EXPECT_FALSE(separate_bodies(shared(together(cube(), inside_out(cube()), Vector3::Zero()))).has_value())
      << "both sides of the same faces";
  EXPECT_FALSE(separate_bodies(shared(together(cube(), cube(), Vector3::Zero()))).has_value());
}

TEST(SeparateBodies, ABodyThatTouchesItselfAtBothEndsOfAnEdgeStaysClosed) {
  // Two columns between two slabs meet along an edge, and hang together round both of its ends.
  const PolygonMesh mesh = cells(2, 2, 3, [](int x, int y, int z) { return z != 1 || x == y; });
  ASSERT_EQ(HalfEdgeMesh::build(mesh).error().code, e_edge_nonmanifold_or_flipped);
  const auto apart = separate_bodies(mesh);
  ASSERT_TRUE(apart.has_value());
  EXPECT_EQ(apart->mesh.positions.size(), mesh.positions.size() + 2);
  const std::vector<double> volumes = volumes_of(apart->mesh);
  ASSERT_EQ(volumes.size(), 1U);
  EXPECT_NEAR(volumes[0], 10, 1e-12);
  const auto repaired = must(make_manifold(mesh));
  EXPECT_EQ(volumes_of(repaired->mesh), volumes);
  EXPECT_EQ(repaired->report.turned_faces, 0U);
}

TEST(SeparateBodies, WhateverCellsAreFilledTheirBoundaryCloses) {
  for_random(1127, 200, [](std::mt19937_64& rng) {
    const int nx = uniform_int(rng, 2, 4), ny = uniform_int(rng, 2, 4), nz = uniform_int(rng, 2, 5);
    std::vector<char> filled(static_cast<std::size_t>(nx * ny * nz));
    const double share = uniform(rng, 0.2, 0.9);
    for (char& cell : filled) cell = chance(rng, share);
    const auto count = static_cast<double>(std::count(filled.begin(), filled.end(), 1));
    const PolygonMesh mesh = cells(nx, ny, nz, [&](int x, int y, int z) {
      return filled[static_cast<std::size_t>((x * ny + y) * nz + z)] != 0;
    });
    if (count == 0 || HalfEdgeMesh::build(mesh).ok()) return;
    for (const double sign : {1.0, -1.0}) {
      const auto apart = separate_bodies(sign > 0 ? mesh : inside_out(mesh));
      ASSERT_TRUE(apart.has_value());
      const std::vector<double> volumes = volumes_of(apart->mesh);
      ASSERT_FALSE(volumes.empty()) << "it has borders";
      EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), sign * count, 1e-9);
    }
  });
}

TEST(SeparateBodies, AFinIsCutOffAndTheBodyStaysClosed) {
  PolygonMesh mesh = cube();
  const auto edge = mesh.face(0);
  const Index a = edge[0], b = edge[1], tip = static_cast<Index>(mesh.positions.size());
  mesh.positions.push_back(2 * mesh.positions[a] - mesh.positions[edge[2]] + Vector3(0.1, 0.2, 0.3));
  mesh.add_face({a, b, tip});
  EXPECT_FALSE(separate_bodies(mesh).has_value());
  const auto repaired = must(make_manifold(mesh));
  const auto topology = must(HalfEdgeMesh::build(repaired->mesh));
  EXPECT_EQ(topology->border_loop_count(), 1U);
  EXPECT_EQ(repaired->report.split_vertices, 2U);
}

/// Frame: a square with a square hole as one face with a bridge, whose sides have vertices of their own where
/// it is asked for.
PolygonMesh frame(bool double_bridge) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0},   {60, 0, 0},  {60, 60, 0}, {0, 60, 0},
                    {20, 20, 0}, {40, 20, 0}, {40, 40, 0}, {20, 40, 0}};
  if (!double_bridge) {
    mesh.add_face({0, 1, 2, 3, 0, 4, 7, 6, 5, 4});
    return mesh;
  }
  mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {20, 20, 0}});
  mesh.add_face({0, 1, 2, 3, 8, 9, 7, 6, 5, 4});
  return mesh;
}

double area_of(const PolygonMesh& mesh) {
  double sum = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vector3 twice = Vector3::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      twice += (mesh.positions[face[k]] - mesh.positions[face[0]])
                   .cross(mesh.positions[face[k + 1]] - mesh.positions[face[0]]);
    sum += twice.norm() / 2;
  }
  return sum;
}

TEST(Keyholes, TheRingIsCoveredAndTheHoleIsNot) {
  const CutKeyholes cut = cut_keyholes(frame(false));
  EXPECT_EQ(cut.cut, 1U);
  const PolygonMesh joined = join_corners(frame(true), 0).mesh;
  const auto repaired = must(make_manifold(frame(false)));
  EXPECT_EQ(repaired->report.cut_faces, 1U);
  EXPECT_EQ(repaired->report.turned_faces, 0U);
  for (const PolygonMesh* mesh : {&cut.mesh, &joined, &repaired->mesh}) {
    const auto topology = must(HalfEdgeMesh::build(*mesh));
    EXPECT_EQ(topology->border_loop_count(), 2U);
    EXPECT_NEAR(area_of(*mesh), 3200, 1e-9);
    EXPECT_EQ(mesh->positions.size(), 8U);
  }
}

TEST(Keyholes, OtherFacesStay) {
  EXPECT_EQ(cut_keyholes(cube()).cut, 0U);
  PolygonMesh eight;  // comes back to a vertex, but walks no side twice
  eight.positions = {{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}};
  eight.add_face({0, 1, 2, 0, 3, 4});
  EXPECT_EQ(cut_keyholes(eight).cut, 0U);
  EXPECT_EQ(make_manifold(eight)->report.cut_faces, 1U) << "no repair is without a count";
  PolygonMesh wrong = frame(false);  // the hole runs round like the rim
  wrong.face_vertices = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  EXPECT_EQ(cut_keyholes(wrong).cut, 0U);
}

TEST(Cavities, LookInwardsAndStaySo) {
  const PolygonMesh hollow = together(scaled(cube(), 4), inside_out(cube()), Vector3::Zero());
  const auto warnings = [](const PolygonMesh& mesh) {
    const std::vector<Message> messages = validate(mesh);
    return std::count_if(messages.begin(), messages.end(),
                         [](const Message& message) { return message.code == w_inside_out; });
  };
  EXPECT_EQ(warnings(hollow), 0);
  EXPECT_EQ(warnings(inside_out(hollow)), 1) << "the outer shell";
  EXPECT_EQ(orient_where_possible(hollow).face_vertices, hollow.face_vertices);
  EXPECT_EQ(volumes_of(orient_where_possible(inside_out(hollow))), volumes_of(hollow));
  EXPECT_GT(volumes_of(orient_where_possible(inside_out(cube()))).at(0), 0);
  // A body within another one that looks like it is none.
  const PolygonMesh nested = together(scaled(cube(), 4), cube(), Vector3::Zero());
  EXPECT_EQ(volumes_of(orient_where_possible(inside_out(nested))), volumes_of(nested));
}

}  // namespace
}  // namespace hariko::test

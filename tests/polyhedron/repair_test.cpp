#include "core/polyhedron/repair.hpp"

#include <algorithm>
#include <numbers>

#include "core/polyhedron/polyhedron.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

PolygonMesh with_random_flips(const PolygonMesh& mesh, std::mt19937_64& rng) {
  PolygonMesh out = mesh;
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    if (chance(rng, 0.5))
      std::reverse(out.face_vertices.begin() + mesh.face_offsets[f],
                   out.face_vertices.begin() + mesh.face_offsets[f + 1]);
  return out;
}

bool has_code(const PolygonMesh& mesh, Code code) {
  const std::vector<Message> messages = validate(mesh);
  return std::any_of(messages.begin(), messages.end(), [&](const Message& m) { return m.code == code; });
}

/// The polygon as a set of points, for comparing faces whose vertices were renumbered or turned.
std::vector<std::array<double, 3>> sorted_corners(const PolygonMesh& mesh, std::size_t f) {
  std::vector<std::array<double, 3>> out;
  for (Index v : mesh.face(f))
    out.push_back({mesh.positions[v].x(), mesh.positions[v].y(), mesh.positions[v].z()});
  std::sort(out.begin(), out.end());
  return out;
}

void expect_same_faces(const PolygonMesh& a, const PolygonMesh& b) {
  ASSERT_EQ(a.face_count(), b.face_count());
  for (std::size_t f = 0; f < a.face_count(); ++f) EXPECT_EQ(sorted_corners(a, f), sorted_corners(b, f));
}

TEST(RepairOrientation, RestoresClosedMeshes) {
  for_random(401, 200, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_closed_polyhedron(rng);
    const auto repaired = must(repair_orientation(with_random_flips(mesh, rng)));
    const auto topology = must(HalfEdgeMesh::build(*repaired));
    for (double volume : closed_component_volumes(*topology, repaired->positions)) EXPECT_GT(volume, 0);
    EXPECT_EQ(repaired->positions, mesh.positions);
    expect_same_faces(*repaired, mesh);
  });
}

TEST(RepairOrientation, RestoresAnyMeshAndLeavesGoodOnesAlone) {
  for_random(402, 200, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const auto repaired = must(repair_orientation(with_random_flips(mesh, rng)));
    EXPECT_TRUE(HalfEdgeMesh::build(*repaired).ok());
    const auto untouched = must(repair_orientation(mesh));
    EXPECT_EQ(untouched->face_vertices, mesh.face_vertices);
  });
}

TEST(RepairOrientation, OpenMeshesKeepTheOrientationOfMostFaces) {
  const PolygonMesh mesh = grid(3, 3);
  for (const std::vector<Index>& flips : {std::vector<Index>{0, 4, 5}, {4, 5, 8}, {0, 1, 2, 3}}) {
    PolygonMesh flipped = mesh;
    for (Index f : flips)
      std::reverse(flipped.face_vertices.begin() + 4 * f + 1, flipped.face_vertices.begin() + 4 * f + 4);
    EXPECT_EQ(repair_orientation(flipped)->face_vertices, mesh.face_vertices);
  }
}

TEST(RepairOrientation, TurnsInsideOutOutward) {
  PolygonMesh mesh = cube();
  for (std::size_t f = 0; f < 6; ++f)
    std::reverse(mesh.face_vertices.begin() + mesh.face_offsets[f] + 1,
                 mesh.face_vertices.begin() + mesh.face_offsets[f + 1]);
  EXPECT_TRUE(has_code(mesh, w_inside_out));
  EXPECT_EQ(repair_orientation(mesh)->face_vertices, cube().face_vertices);
}

/// A strip of n quads whose end is glued to its start with a half turn.
PolygonMesh moebius(int n) {
  PolygonMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int side : {-1, 1}) {
      const double a = 2 * std::numbers::pi * i / n;
      const double r = 2 + side * std::cos(a / 2) / 2;
      mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), side * std::sin(a / 2) / 2);
    }
  for (int i = 0; i < n; ++i) {
    const auto at = [n](int k, int side) {
      return static_cast<Index>(2 * (k % n) + (k >= n ? 1 - side : side));
    };
    mesh.add_face({at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1)});
  }
  return mesh;
}

TEST(RepairOrientation, RefusesOneSidedSurfaces) {
  const auto result = repair_orientation(moebius(7));
  must_fail(result, e_edge_nonmanifold_or_flipped);
  EXPECT_EQ(result.error().element.kind, Element::Kind::edge);
  EXPECT_NE(result.error().text.find("one side"), std::string::npos);
}

PolygonMesh three_wings() {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  for (Index wing : {2U, 3U, 4U}) mesh.add_face({0, 1, wing});
  return mesh;
}

TEST(RepairOrientation, RefusesEdgesWithThreeFaces) {
  const auto result = repair_orientation(three_wings());
  must_fail(result, e_edge_nonmanifold_or_flipped);
  EXPECT_EQ(result.error().element, element_of(EdgeId::of(VertexId{0}, VertexId{1})));
}

TEST(SplitNonmanifoldEdges, SeparatesWings) {
  const PolygonMesh split = split_nonmanifold_edges(three_wings());
  EXPECT_TRUE(HalfEdgeMesh::build(split).ok());
  EXPECT_EQ(split.positions.size(), 9U);
  expect_same_faces(split, three_wings());
}

TEST(SplitNonmanifoldEdges, CutsMoebiusStripOpen) {
  const PolygonMesh split = split_nonmanifold_edges(moebius(7));
  const auto topology = must(HalfEdgeMesh::build(split));
  EXPECT_EQ(topology->border_loop_count(), 1U);
  EXPECT_EQ(split.positions.size(), 16U);
}

TEST(SplitNonmanifoldEdges, TwoCubesAlongAnEdge) {
  // Four faces at the common edge: each cube's two stay together.
  const PolygonMesh mesh = weld(together(cube(), cube(), {2, 2, 0}), 0);
  ASSERT_TRUE(has_code(mesh, e_edge_nonmanifold_or_flipped));
  const PolygonMesh split = split_nonmanifold_edges(mesh);
  const auto topology = must(HalfEdgeMesh::build(split));
  EXPECT_EQ(split.positions.size(), 16U);
  EXPECT_EQ(topology->border_loop_count(), 0U);
}

TEST(SplitNonmanifoldVertices, SeparatesCubesThatTouchInACorner) {
  const PolygonMesh mesh = weld(together(cube(), cube(), {2, 2, 2}), 0);
  ASSERT_EQ(mesh.positions.size(), 15U);
  const PolygonMesh split = split_nonmanifold_vertices(mesh);
  EXPECT_TRUE(HalfEdgeMesh::build(split).ok());
  EXPECT_EQ(split.positions.size(), 16U);
  EXPECT_EQ(split.positions.back(), Vector3(1, 1, 1));
  EXPECT_TRUE(std::equal(mesh.positions.begin(), mesh.positions.end(), split.positions.begin()));
  expect_same_faces(split, mesh);
}

TEST(Splits, MakeAnyBlobOfCellsManifold) {
  for_random(403, 300, [](std::mt19937_64& rng) {
    const int n = uniform_int(rng, 2, 4);
    std::vector<char> filled(static_cast<std::size_t>(n * n * n));
    for (char& cell : filled) cell = chance(rng, 0.4);
    filled[0] = 1;
    const PolygonMesh mesh = cells(n, n, n, [&](int x, int y, int z) {
      return filled[static_cast<std::size_t>((x * n + y) * n + z)] != 0;
    });
    const PolygonMesh split = split_nonmanifold_vertices(split_nonmanifold_edges(mesh));
    const auto topology = HalfEdgeMesh::build(split);
    ASSERT_TRUE(topology.ok()) << to_string(topology.error());
    expect_same_faces(split, mesh);
  });
}

TEST(Splits, RandomTrianglesBecomeManifold) {
  for_random(404, 1000, [](std::mt19937_64& rng) {
    PolygonMesh mesh;
    const int vertices = uniform_int(rng, 3, 7);
    for (int v = 0; v < vertices; ++v) mesh.positions.push_back(random_vector(rng));
    for (int f = uniform_int(rng, 1, 12); f > 0; --f) {
      const Index a = static_cast<Index>(uniform_int(rng, 0, vertices - 1));
      Index b = a, c = a;
      while (b == a) b = static_cast<Index>(uniform_int(rng, 0, vertices - 1));
      while (c == a || c == b) c = static_cast<Index>(uniform_int(rng, 0, vertices - 1));
      mesh.add_face({a, b, c});
    }
    const PolygonMesh split = split_nonmanifold_vertices(split_nonmanifold_edges(mesh));
    const auto topology = HalfEdgeMesh::build(split);
    ASSERT_TRUE(topology.ok()) << to_string(topology.error());
    expect_same_faces(split, mesh);
  });
}

TEST(Splits, LeaveManifoldMeshesAlone) {
  for_random(405, 100, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    for (const PolygonMesh& same : {split_nonmanifold_edges(mesh), split_nonmanifold_vertices(mesh)}) {
      EXPECT_EQ(same.positions, mesh.positions);
      EXPECT_EQ(same.face_vertices, mesh.face_vertices);
    }
  });
}

TEST(RemoveIsolatedVertices, RenumbersTheRest) {
  PolygonMesh mesh = cube();
  mesh.positions.insert(mesh.positions.begin() + 2, 3, Vector3(7, 7, 7));
  for (Index& v : mesh.face_vertices) v += v >= 2 ? 3 : 0;
  EXPECT_TRUE(has_code(mesh, w_isolated_vertex));
  const PolygonMesh clean = remove_isolated_vertices(mesh);
  EXPECT_EQ(clean.positions, cube().positions);
  EXPECT_EQ(clean.face_vertices, cube().face_vertices);
}

/// Every face with vertices of its own, as STL files have it.
PolygonMesh exploded(const PolygonMesh& mesh) {
  PolygonMesh out;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> face;
    for (Index v : mesh.face(f)) {
      face.push_back(static_cast<Index>(out.positions.size()));
      out.positions.push_back(mesh.positions[v]);
    }
    out.add_face(face);
  }
  return out;
}

TEST(Weld, PutsExplodedMeshesTogether) {
  for_random(406, 200, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const PolygonMesh welded = weld(exploded(mesh), 0);
    EXPECT_EQ(welded.positions.size(), mesh.positions.size());
    EXPECT_TRUE(HalfEdgeMesh::build(welded).ok());
    expect_same_faces(welded, mesh);
  });
}

TEST(Weld, MergesWithinTheDistanceOnly) {
  for_random(407, 200, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const double distance = shortest_edge(mesh) * 1e-3;
    PolygonMesh noisy = exploded(mesh);
    for (Vector3& p : noisy.positions) p += random_vector(rng).normalized() * (0.49 * distance);
    EXPECT_EQ(weld(noisy, distance).positions.size(), mesh.positions.size());
    EXPECT_TRUE(HalfEdgeMesh::build(weld(noisy, distance)).ok());
    EXPECT_EQ(weld(noisy, distance * 1e-9).positions.size(), noisy.positions.size());
  });
}

TEST(Weld, AgreesWithTheDefinition) {
  // The rule in its plain quadratic form: an earlier kept vertex within the distance, the nearest of them,
  // takes over.
  for_random(408, 300, [](std::mt19937_64& rng) {
    PolygonMesh mesh;
    for (int i = 0; i < 60; ++i) mesh.positions.push_back(random_vector(rng, log_uniform(rng, 0.01, 10)));
    const double distance = log_uniform(rng, 0.01, 3);
    std::vector<Vector3> kept;
    for (const Vector3& p : mesh.positions)
      if (std::none_of(kept.begin(), kept.end(),
                       [&](const Vector3& q) { return (p - q).norm() <= distance; }))
        kept.push_back(p);
    EXPECT_EQ(weld(mesh, distance).positions, kept);
  });
}

TEST(Weld, ShrinksAndDropsFaces) {
  PolygonMesh mesh = grid(2, 1);
  mesh.positions[1] = mesh.positions[0];
  PolygonMesh welded = weld(mesh, 0);
  ASSERT_EQ(welded.face_count(), 2U);
  EXPECT_EQ(welded.face(0).size(), 3U);
  mesh.positions[4] = mesh.positions[3];
  welded = weld(mesh, 0);
  ASSERT_EQ(welded.face_count(), 1U);
  EXPECT_EQ(welded.face(0).size(), 4U);
}

TEST(Weld, FacesShrinkAcrossTheirFirstCorner) {
  PolygonMesh mesh = grid(1, 1);
  mesh.positions[2] = mesh.positions[0];  // the last corner of 0 1 3 2 falls on the first
  const PolygonMesh welded = weld(mesh, 0);
  ASSERT_EQ(welded.face_count(), 1U);
  EXPECT_EQ(welded.face_vertices, (std::vector<Index>{0, 1, 2}));
  EXPECT_TRUE(HalfEdgeMesh::build(welded).ok());
}

TEST(Weld, TheEarliestOfEquallyNearVerticesTakesOver) {
  for (double side : {-1.0, 1.0}) {
    PolygonMesh mesh;
    mesh.positions = {{side, 0, 0}, {-side, 0, 0}, {0, 0, 0}, {0, 5, 0}, {0, 0, 5}};
    mesh.add_face({2, 3, 4});
    EXPECT_EQ(weld(mesh, 1).face_vertices, (std::vector<Index>{0, 2, 3}));
  }
}

TEST(Weld, ZerosOfEitherSignAreEqualAndNanIsNot) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {-0.0, 0, -0.0}, {std::nan(""), 0, 0}, {std::nan(""), 0, 0}};
  EXPECT_EQ(weld(mesh, 0).positions.size(), 3U);
  EXPECT_EQ(weld(mesh, 1).positions.size(), 3U);
  EXPECT_EQ(weld(mesh, 1e-320).positions.size(), 3U);
  EXPECT_EQ(weld(mesh, std::numeric_limits<double>::infinity()).positions.size(), 3U);
}

TEST(Repairs, SurviveGarbage) {
  for_random(409, 1000, [](std::mt19937_64& rng) {
    PolygonMesh mesh;
    const int vertices = uniform_int(rng, 0, 6);
    for (int v = 0; v < vertices; ++v) mesh.positions.push_back(random_vector(rng).array().round());
    for (int f = uniform_int(rng, 0, 8); f > 0; --f) {
      std::vector<Index> face;
      for (int i = uniform_int(rng, 0, 5); i > 0; --i)
        face.push_back(static_cast<Index>(uniform_int(rng, 0, 7)));
      mesh.add_face(face);
    }
    const auto oriented = repair_orientation(mesh);
    if (oriented.ok()) {
      EXPECT_EQ(oriented->face_count(), mesh.face_count());
    }
    const PolygonMesh split = split_nonmanifold_vertices(split_nonmanifold_edges(mesh));
    EXPECT_FALSE(has_code(split, e_edge_nonmanifold_or_flipped));
    EXPECT_FALSE(has_code(split, e_vertex_nonmanifold));
    const PolygonMesh clean = remove_isolated_vertices(weld(mesh, 0.5));
    EXPECT_FALSE(has_code(clean, w_isolated_vertex));
    EXPECT_FALSE(has_code(clean, e_face_too_small));
  });
}

}  // namespace
}  // namespace hariko::test

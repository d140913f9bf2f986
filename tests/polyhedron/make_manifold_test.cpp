// make_manifold: whatever a file holds becomes a polyhedron or is refused; what is sound stays as it is.

#include <algorithm>

#include "core/polyhedron/polyhedron.hpp"
#include "core/polyhedron/repair.hpp"
#include "core/polyhedron/validation.hpp"
#include "core/polyhedron/volume.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

void reverse_face(PolygonMesh& mesh, std::size_t f) {
  std::reverse(mesh.face_vertices.begin() + mesh.face_offsets[f],
               mesh.face_vertices.begin() + mesh.face_offsets[f + 1]);
}

TEST(MakeManifold, LeavesSoundMeshesAlone) {
  for_random(771, 200, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_polyhedron(rng);
    const auto repaired = must(make_manifold(mesh));
    EXPECT_EQ(repaired->report, RepairReport{});
    EXPECT_EQ(repaired->mesh.positions, mesh.positions);
    EXPECT_EQ(repaired->mesh.face_vertices, mesh.face_vertices);
    EXPECT_EQ(repaired->mesh.face_offsets, mesh.face_offsets);
  });
}

TEST(MakeManifold, RestoresWhatAFileSpoiled) {
  // Faces of their own, some turned, positions off by rounding, and unused vertices: the closed shape is
  // back.
  for_random(772, 200, [](std::mt19937_64& rng) {
    const PolygonMesh mesh = random_closed_polyhedron(rng);
    PolygonMesh spoiled;
    spoiled.positions.emplace_back(1e3, 0, 0);
    std::size_t turned = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      std::vector<Index> face;
      for (const Index v : mesh.face(f)) {
        face.push_back(static_cast<Index>(spoiled.positions.size()));
        spoiled.positions.push_back(mesh.positions[v] + 1e-9 * shortest_edge(mesh) * random_vector(rng));
      }
      spoiled.add_face(face);
      if (!chance(rng, 0.3)) continue;
      reverse_face(spoiled, f);
      ++turned;
    }
    const auto repaired = must(make_manifold(spoiled));
    const auto topology = must(HalfEdgeMesh::build(repaired->mesh));
    EXPECT_EQ(repaired->mesh.positions.size(), mesh.positions.size());
    EXPECT_EQ(topology->border_loop_count(), 0U);
    for (const double volume : closed_component_volumes(*topology, repaired->mesh.positions))
      EXPECT_GT(volume, 0);
    EXPECT_EQ(repaired->report.turned_faces, turned);
    EXPECT_EQ(repaired->report.removed_vertices, 1U);
    EXPECT_EQ(repaired->report.merged_vertices, mesh.face_vertices.size() - mesh.positions.size());
    EXPECT_EQ(repaired->report.dropped_faces, 0U);
    EXPECT_EQ(repaired->report.split_vertices, 0U);
  });
}

TEST(MakeManifold, OrientsTheWingsOfAnEdgeWithThreeFacesBeforeItCutsThemApart) {
  // Three strips of two quads along one edge; in each the outer quad is turned the wrong way.
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}};
  for (int wing = 0; wing < 3; ++wing) {
    const double angle = 2.1 * wing;
    const Vector3 out(std::cos(angle), std::sin(angle), 0);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const double far : {1.0, 2.0})
      for (const double z : {0.0, 1.0}) mesh.positions.push_back(far * out + Vector3(0, 0, z));
    mesh.add_face({0, first, first + 1, 1});
    mesh.add_face({first, first + 1, first + 3, first + 2});
  }
  ASSERT_FALSE(HalfEdgeMesh::build(mesh).ok());
  const auto repaired = must(make_manifold(mesh));
  const auto topology = must(HalfEdgeMesh::build(repaired->mesh));
  EXPECT_EQ(topology->border_loop_count(), 3U) << "a wing fell apart";
  EXPECT_EQ(repaired->report.split_vertices, 4U);
  EXPECT_EQ(repaired->report.turned_faces, 3U);
}

TEST(MakeManifold, DropsDoubleFacesButKeepsALens) {
  PolygonMesh mesh = cube();
  mesh.add_face(std::vector<Index>(mesh.face(2).begin(), mesh.face(2).end()));
  const auto repaired = must(make_manifold(mesh));
  EXPECT_EQ(repaired->report.dropped_faces, 1U);
  EXPECT_EQ(repaired->mesh.face_vertices, cube().face_vertices);

  PolygonMesh lens;
  lens.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  lens.add_face({0, 1, 2});
  lens.add_face({0, 2, 1});
  EXPECT_EQ(make_manifold(lens)->mesh.face_count(), 2U);
}

TEST(MakeManifold, AFaceThatComesBackToAVertexBecomesSeveral) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}};
  mesh.add_face({0, 1, 2, 0, 3, 4});
  EXPECT_EQ(split_repeated_corners(mesh).face_count(), 2U);
  const auto repaired = must(make_manifold(mesh));
  EXPECT_TRUE(HalfEdgeMesh::build(repaired->mesh).ok());
  EXPECT_EQ(repaired->mesh.face_count(), 2U);
}

TEST(MakeManifold, SplitFacesDoNotHideThatOthersWereDropped) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}, {0, 0, 3}};
  mesh.add_face({0, 1, 2, 0, 3, 4});  // becomes two
  mesh.add_face({1, 2, 9});           // has a vertex that does not exist
  mesh.add_face({0, 5, 0, 5});        // has no loop
  const auto repaired = must(make_manifold(mesh));
  EXPECT_EQ(repaired->mesh.face_count(), 2U);
  EXPECT_EQ(repaired->report.dropped_faces, 2U);

  // Faces of a cube, and one whose two loops are two of them.
  PolygonMesh doubled = cube();
  std::vector<Index> both(doubled.face(0).begin(), doubled.face(0).end());
  std::vector<Index> next;
  for (std::size_t f = 1; next.empty(); ++f)
    if (std::find(doubled.face(f).begin(), doubled.face(f).end(), both[0]) != doubled.face(f).end())
      next.assign(doubled.face(f).begin(), doubled.face(f).end());
  std::rotate(next.begin(), std::find(next.begin(), next.end(), both[0]), next.end());
  both.insert(both.end(), next.begin(), next.end());
  doubled.add_face(both);
  const auto parted = must(make_manifold(doubled));
  EXPECT_EQ(parted->mesh.face_vertices, cube().face_vertices);
  EXPECT_EQ(parted->report.dropped_faces, 2U) << "both parts of the face were there already";
}

TEST(MakeManifold, GarbageBecomesAPolyhedronOrIsRefused) {
  int made = 0, refused = 0;
  for_random(773, 1500, [&](std::mt19937_64& rng) {
    PolygonMesh mesh;
    const int vertices = uniform_int(rng, 0, 7);
    for (int v = 0; v < vertices; ++v) mesh.positions.push_back(random_vector(rng, 2).array().round());
    for (int f = uniform_int(rng, 0, 9); f > 0; --f) {
      std::vector<Index> face;
      for (int i = uniform_int(rng, 0, 6); i > 0; --i)
        face.push_back(static_cast<Index>(uniform_int(rng, 0, 8)));
      mesh.add_face(face);
    }
    const auto repaired = make_manifold(mesh);
    if (!repaired.ok()) {
      ++refused;
      EXPECT_EQ(repaired.error().code, e_no_faces);
      return;
    }
    ++made;
    const auto polyhedron = Polyhedron::build(repaired->mesh);
    ASSERT_TRUE(polyhedron.ok()) << to_string(polyhedron.error());
    // Once repaired there is nothing left to repair.
    const auto again = must(make_manifold(repaired->mesh));
    EXPECT_EQ(again->mesh.face_count(), repaired->mesh.face_count());
    EXPECT_EQ(again->report.dropped_faces, 0U);
  });
  EXPECT_GT(made, 50);
  EXPECT_GT(refused, 10);
}

TEST(MakeManifold, PositionsThatAreNoNumbersAreRefused) {
  PolygonMesh mesh = cube();
  mesh.positions[3].y() = std::nan("");
  const auto repaired = make_manifold(mesh);
  must_fail(repaired, e_nonfinite);
  EXPECT_EQ(repaired.error().element, element_of(VertexId{3}));
}

}  // namespace
}  // namespace hariko::test

// Meshes of other programs made tidy: corners joined, triangles without area dropped.

#include "core/polyhedron/join_corners.hpp"

#include <array>
#include <set>

#include "core/polyhedron/edge_table.hpp"
#include "core/polyhedron/mesh_errors.hpp"
#include "tests/support/random.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko {
namespace {

/// Every face with corners of its own, each moved by at most `noise`.
PolygonMesh loose(const PolygonMesh& mesh, double noise, std::mt19937_64& rng) {
  PolygonMesh out;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    std::vector<Index> corners;
    for (const Index v : mesh.face(f)) {
      corners.push_back(Index(out.positions.size()));
      Vector3 away = test::random_vector(rng, 1);
      away *= noise / std::max(1.0, 2 * away.norm());
      out.positions.push_back(mesh.positions[v] + away);
    }
    out.add_face(corners);
  }
  return out;
}

/// Edges without two faces.
std::size_t open_edges(const PolygonMesh& mesh) {
  std::size_t count = 0;
  EdgeTable(mesh).for_each_edge(
      [&](Index, Index, std::span<const EdgeUse> uses) { count += uses.size() != 2; });
  return count;
}

bool is_sound(const PolygonMesh& mesh) {
  return connectivity_errors(mesh, 1).empty();
}

TEST(JoinCorners, LooseFacesBecomeTheMeshThatTheyWere) {
  test::for_random(1, 12, [](std::mt19937_64& rng) {
    const double size = std::pow(10, test::uniform(rng, -3, 6));
    PolygonMesh whole = test::torus(test::uniform_int(rng, 3, 9), test::uniform_int(rng, 3, 9));
    const Vector3 shift = test::random_vector(rng, test::chance(rng, 0.5) ? 1e6 * size : 0);
    for (Vector3& p : whole.positions) p = size * p + shift;
    const PolygonMesh apart = loose(whole, 0, rng);
    const TidyMesh joined = join_corners(apart, 0);
    EXPECT_EQ(joined.mesh.positions.size(), whole.positions.size());
    EXPECT_EQ(joined.joined, apart.positions.size() - whole.positions.size());
    EXPECT_EQ(joined.farthest, 0);
    EXPECT_EQ(open_edges(joined.mesh), 0U);
    for (Index v = 0; v < apart.positions.size(); ++v)
      EXPECT_EQ(joined.mesh.positions[joined.vertex_of[v]], apart.positions[v]);
    // Near ones need a distance.
    const double noise = 1e-7 * used_size(whole);
    const PolygonMesh near = loose(whole, noise, rng);
    EXPECT_GT(near_corners(near, usual_joining_distance * used_size(near)).count, 0U);
    const TidyMesh closed = join_corners(near, usual_joining_distance * used_size(near));
    EXPECT_EQ(closed.mesh.positions.size(), whole.positions.size());
    EXPECT_LE(closed.farthest, noise + 1e-15 * shift.norm());
    EXPECT_EQ(open_edges(closed.mesh), 0U);
  });
}

TEST(JoinCorners, BodiesAndSheetsThatTouchStayApart) {
  // Two octahedra that share the place of a vertex, as numbers of their own.
  PolygonMesh two = test::octahedron();
  const Vector3 tip = two.positions[two.face(0)[0]];
  const auto before = Index(two.positions.size());
  const PolygonMesh one = two;
  for (const Vector3& p : one.positions) two.positions.push_back(p + 2 * tip);
  for (std::size_t f = 0; f < one.face_count(); ++f) {
    std::vector<Index> corners;
    for (const Index v : one.face(f)) corners.push_back(before + v);
    two.add_face(corners);
  }
  EXPECT_EQ(join_corners(two, 0).joined, 0U);
  EXPECT_TRUE(is_sound(join_corners(two, 0).mesh));
  // Two squares that touch in a corner, and a third at an edge of the first two.
  PolygonMesh sheets;
  sheets.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  sheets.add_face({0, 1, 2, 3});
  sheets.add_face({4, 5, 6, 7});
  const TidyMesh touching = join_corners(sheets, 0);
  EXPECT_TRUE(is_sound(touching.mesh));
  EXPECT_EQ(touching.joined, 0U);
  EXPECT_EQ(touching.mesh.positions.size(), 8U);
}

TEST(JoinCorners, FacesThatLoseTheirCornersAreDroppedAndOthersShrink) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.add_face({0, 1, 2, 3, 4});
  mesh.add_face({1, 2, 3});
  mesh.add_face({0, 0, 1});
  const TidyMesh tidy = join_corners(mesh, 0);
  ASSERT_EQ(tidy.mesh.face_count(), 1U);
  EXPECT_EQ(tidy.mesh.face(0).size(), 4U);
  EXPECT_EQ(tidy.collapsed, 2U);
  // Faults that validation is to tell stay.
  mesh.add_face({0, 9, 1});
  mesh.add_face({0, 1});
  EXPECT_FALSE(is_sound(join_corners(mesh, 0).mesh));
}

/// A cube of triangles with a corner at zero.
PolygonMesh cube_of_triangles() {
  PolygonMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.positions.emplace_back(k & 1, k >> 1 & 1, k >> 2 & 1);
  for (const auto& quad : {std::array<Index, 4>{0, 2, 3, 1},
                           {4, 5, 7, 6},
                           {0, 1, 5, 4},
                           {2, 6, 7, 3},
                           {0, 4, 6, 2},
                           {1, 3, 7, 5}}) {
    mesh.add_face({quad[0], quad[1], quad[2]});
    mesh.add_face({quad[0], quad[2], quad[3]});
  }
  return mesh;
}

TEST(DropFlatTriangles, OnesAlongAnEdgeAreDropped) {
  PolygonMesh mesh = cube_of_triangles();
  mesh.positions.emplace_back(0.25, 0, 0);
  mesh.add_face({0, 8, 1});
  EXPECT_FALSE(is_sound(mesh));
  const TidyMesh tidy = drop_flat_triangles(mesh);
  EXPECT_EQ(tidy.flat, 1U);
  EXPECT_EQ(tidy.mesh.face_count(), 12U);
  EXPECT_EQ(open_edges(tidy.mesh), 0U);
  EXPECT_EQ(drop_flat_triangles(cube_of_triangles()).flat, 0U);
}

TEST(DropFlatTriangles, OnesThatFillTJointsAreTurned) {
  // The edge 0-1 of one side is cut at two places of the other, and flat triangles fill the gap.
  PolygonMesh mesh = cube_of_triangles();
  PolygonMesh cut;
  cut.positions = mesh.positions;
  cut.positions.emplace_back(0.25, 0, 0);
  cut.positions.emplace_back(0.75, 0, 0);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (std::set<Index>(face.begin(), face.end()) == std::set<Index>{0, 1, 5}) {
      cut.add_face({0, 8, 5});
      cut.add_face({8, 9, 5});
      cut.add_face({9, 1, 5});
    } else {
      cut.add_face(face);
    }
  }
  EXPECT_EQ(open_edges(cut), 4U);
  cut.add_face({1, 8, 0});
  cut.add_face({1, 9, 8});
  EXPECT_EQ(open_edges(cut), 0U);
  const TidyMesh tidy = drop_flat_triangles(cut);
  EXPECT_EQ(tidy.flat, 2U);
  EXPECT_EQ(open_edges(tidy.mesh), 0U);
  EXPECT_EQ(drop_flat_triangles(tidy.mesh).flat, 0U) << "none is left";
}

}  // namespace
}  // namespace hariko

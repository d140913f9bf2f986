#include "core/exchange/repair/clean_part.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/polyhedron/polyhedron.hpp"
#include "core/polyhedron/repair.hpp"
#include "tests/exchange/fixture_files.hpp"

namespace hariko {
namespace {

TEST(CleanPart, MarksGoAlongAndWhatIsLeftBehindGoes) {
  ImportedPart part;
  // Two triangles that share an edge only by place, one collapsed one, and a vertex that nothing uses.
  part.mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                         {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}};
  part.mesh.add_face({1, 2, 3});
  part.mesh.add_face({4, 5, 6});
  part.mesh.add_face({7, 7, 1});
  part.creases = {{4, 6}, {2, 4}};
  part.corners = {6};
  CleanReport report;
  clean(part, {}, report);
  EXPECT_EQ(report.joined, 2U);
  EXPECT_EQ(report.collapsed, 1U);
  ASSERT_EQ(part.mesh.positions.size(), 5U);
  EXPECT_EQ(part.mesh.positions[0], Vector3(9, 9, 9)) << "the file's own vertex stays";
  EXPECT_EQ(part.mesh.face_count(), 2U);
  ASSERT_EQ(part.creases.size(), 1U);
  EXPECT_EQ(part.mesh.positions[part.creases[0][0]], Vector3(1, 0, 0));
  EXPECT_EQ(part.mesh.positions[part.creases[0][1]], Vector3(0, 1, 0));
  EXPECT_EQ(part.mesh.positions[part.corners[0]], Vector3(0, 1, 0));
  std::vector<std::string> codes;
  for (const Message& message : report.messages()) codes.emplace_back(message.code.name);
  EXPECT_EQ(codes, (std::vector<std::string>{"W_CORNERS_JOINED", "W_DEGENERATE_TRIANGLES"}));
}

TEST(CleanPart, NearCornersAreToldOrJoined) {
  ImportedPart part;
  part.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + 1e-7, 0, 0}, {1, 1, 0}, {0, 1, 1e-7}};
  part.mesh.add_face({0, 1, 2});
  part.mesh.add_face({3, 4, 5});
  ImportedPart joined = part;
  CleanReport told, done;
  clean(part, {}, told);
  EXPECT_EQ(told.near, 2U);
  EXPECT_NEAR(told.near_farthest, 1e-7, 1e-12);
  EXPECT_EQ(part.mesh.positions.size(), 6U);
  ASSERT_EQ(told.messages().size(), 1U);
  EXPECT_NE(told.messages()[0].remedy.find("--weld 1.42e-06)"), std::string::npos)
      << "three digits, not less than the square root of 2: " << told.messages()[0].remedy;
  clean(joined, {.near = true}, done);
  EXPECT_EQ(done.near_joined, 2U);
  EXPECT_EQ(joined.mesh.positions.size(), 4U);
  EXPECT_NEAR(done.farthest, 1e-7, 1e-12);
  CleanReport strict;
  clean(part, {.near = true, .distance = 1e-8}, strict);
  EXPECT_EQ(strict.joined, 0U);
}

TEST(CleanPart, NoToleranceIsNamedWhereMeshesHaveTheirOwn) {
  // Two triangles that lie side by side, and the same a million times as large.
  CleanReport report;
  for (const double size : {1.0, 1e6}) {
    ImportedPart part;
    part.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1 + 1e-7, 0, 0}, {1, 1, 0}, {0, 1, 1e-7}};
    for (Vector3& position : part.mesh.positions) position *= size;
    part.mesh.add_face({0, 1, 2});
    part.mesh.add_face({3, 4, 5});
    clean(part, {}, report);
  }
  EXPECT_EQ(report.near, 4U);
  ASSERT_EQ(report.messages().size(), 1U);
  EXPECT_NE(report.messages()[0].remedy.find("(--weld)"), std::string::npos) << report.messages()[0].remedy;
}

TEST(CleanPart, CreasesRunAlongSplitEdges) {
  // A rectangle below two squares, whose common corner lies on its upper side.
  ImportedPart part;
  part.mesh.positions = {{0, 0, 0},  {20, 0, 0},  {20, 10, 0}, {0, 10, 0},
                         {0, 20, 0}, {10, 20, 5}, {20, 20, 0}, {10, 10, 0}};
  part.mesh.add_face({0, 1, 2, 3});
  part.mesh.add_face({3, 7, 5, 4});
  part.mesh.add_face({7, 2, 6, 5});
  part.creases = {{2, 3}};
  CleanReport report;
  clean(part, {.split_edges = true}, report);
  EXPECT_EQ(report.split_edges, 1U);
  for (auto& [a, b] : part.creases)
    if (a > b) std::swap(a, b);
  std::sort(part.creases.begin(), part.creases.end());
  ASSERT_EQ(part.creases.size(), 2U);
  EXPECT_EQ(part.creases[0], (std::array<Index, 2>{2, 7}));
  EXPECT_EQ(part.creases[1], (std::array<Index, 2>{3, 7}));
}

TEST(CleanPart, CornersOfLooseFacesMayBeFartherApart) {
  ImportedPart loose;
  loose.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 4e-4, 0}, {1, 1, 0}, {0, 1, 4e-4}};
  loose.mesh.add_face({0, 1, 2});
  loose.mesh.add_face({3, 4, 5});
  // A third face makes a surface of the first one: then its borders may lie beside others.
  ImportedPart surface = loose;
  surface.mesh.positions.push_back({0, 0, 1});
  surface.mesh.add_face({1, 0, 6});
  CleanReport told, quiet;
  clean(loose, {}, told);
  EXPECT_EQ(told.near, 2U);
  EXPECT_NEAR(told.near_farthest, 4e-4, 1e-9);
  EXPECT_EQ(loose.mesh.positions.size(), 6U) << "nobody asked for it";
  clean(surface, {}, quiet);
  EXPECT_EQ(quiet.near, 0U);
  // The tolerance that is named is enough.
  CleanReport done;
  clean(loose, {.near = true, .distance = told.tolerance}, done);
  EXPECT_EQ(done.near_joined, 2U);
  // Small facets are not their own neighbours.
  ImportedPart dense;
  for (int k = 0; k < 40; ++k) {
    const Vector3 at(50.0 * k, 0, 0);
    const Index first = Index(dense.mesh.positions.size());
    for (const Vector3& corner : {Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(0, 1, 0)})
      dense.mesh.positions.push_back(at + corner);
    dense.mesh.add_face({first, first + 1, first + 2});
  }
  CleanReport apart;
  clean(dense, {}, apart);
  EXPECT_EQ(apart.near, 0U);
}

TEST(CleanPart, AStrayPartFarAwayMakesNoCornersNear) {
  // A sheet with sides of a tenth, and a triangle ten million away: a millionth of the whole is ten.
  PolygonMesh mesh = test::grid(20, 20);
  const auto first = static_cast<Index>(mesh.positions.size());
  for (const Vector3& corner : {Vector3(1e7, 0, 0), Vector3(1e7, 0.1, 0), Vector3(1e7, 0, 0.1)})
    mesh.positions.push_back(corner);
  mesh.add_face({first, first + 1, first + 2});
  for (const bool near : {false, true}) {
    ImportedPart part{mesh, "sheet"};
    CleanReport report;
    clean(part, {.near = near, .split_edges = true}, report);
    EXPECT_EQ(part.mesh.positions, mesh.positions);
    EXPECT_EQ(part.mesh.face_vertices, mesh.face_vertices);
    EXPECT_TRUE(report.messages().empty());
    EXPECT_LT(report.tolerance, 0.02);
  }
  const auto repaired = test::must(make_manifold(mesh));
  EXPECT_EQ(repaired->report, RepairReport{});
}

TEST(CleanPart, BodiesThatShareCornersAreToldApartWithTheirMarks) {
  const PolygonMesh two = weld(test::together(test::cube(), test::cube(), {2, 2, 0}), 0);
  ASSERT_EQ(two.positions.size(), 14U);
  ImportedPart part{two, "two"};
  part.creases = {{6, 2}};  // they touch there, x = y = 1
  part.corners = {6};
  CleanReport report;
  clean(part, {}, report);
  EXPECT_EQ(report.apart, 2U);
  const auto built = test::must(Polyhedron::build(part.mesh));
  EXPECT_EQ(built->topology().border_loop_count(), 0U);
  EXPECT_EQ(part.creases.size(), 2U);
  for (const auto& [a, b] : part.creases) {
    EXPECT_NE(built->find(EdgeId::of(VertexId{a}, VertexId{b})), no_index);
    EXPECT_EQ(part.mesh.positions[a].x(), 1);
    EXPECT_EQ(part.mesh.positions[b].y(), 1);
  }
  EXPECT_EQ(part.corners.size(), 2U);
  ASSERT_EQ(report.messages().size(), 1U);
  EXPECT_EQ(report.messages()[0].code, w_bodies_apart);
}

TEST(CleanPart, ABodyThatTouchesItselfAlongAWholeEdgeOpensFromEveryFormat) {
  // Two columns between two slabs meet along an edge.
  const PolygonMesh body = test::cells(2, 2, 3, [](int x, int y, int z) { return z != 1 || x == y; });
  std::string off =
      "OFF\n" + std::to_string(body.positions.size()) + ' ' + std::to_string(body.face_count()) + " 0\n";
  std::string obj, stl = "solid body\n";
  const auto text_of = [](const Vector3& p) {
    return std::to_string(p.x()) + ' ' + std::to_string(p.y()) + ' ' + std::to_string(p.z()) + '\n';
  };
  for (const Vector3& p : body.positions) {
    off += text_of(p);
    obj += "v " + text_of(p);
  }
  for (std::size_t f = 0; f < body.face_count(); ++f) {
    const auto face = body.face(f);
    off += "4";
    obj += "f";
    for (const Index v : face) {
      off += ' ' + std::to_string(v);
      obj += ' ' + std::to_string(v + 1);
    }
    off += '\n';
    obj += '\n';
    for (const std::size_t k : {1U, 2U}) {
      stl += "facet normal 0 0 0\nouter loop\n";
      for (const Index v : {face[0], face[k], face[k + 1]}) stl += "vertex " + text_of(body.positions[v]);
      stl += "endloop\nendfacet\n";
    }
  }
  stl += "endsolid body\n";
  for (const auto& [format, text] :
       {std::pair{MeshFormat::off, off}, std::pair{MeshFormat::obj, obj}, std::pair{MeshFormat::stl, stl}}) {
    auto scene = test::must(read_parts(text, format, {}, {}));
    ImportedPart& part = scene.value().parts.at(0);
    CleanReport report;
    clean(part, {}, report);
    EXPECT_EQ(report.apart, 2U);
    const auto built = test::must(Polyhedron::build(part.mesh));
    EXPECT_EQ(built->topology().border_loop_count(), 0U);
    EXPECT_EQ(built->topology().face_components().back(), 0U) << "one body";
  }
}

TEST(CleanPart, CornersOnEdgesAreToldOrTheEdgesAreSplit) {
  // A tetrahedron of which one face is two triangles that divide the edge 0-1.
  ImportedPart part;
  part.mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 0, 0}};
  part.mesh.add_face({0, 2, 1});
  part.mesh.add_face({0, 3, 2});
  part.mesh.add_face({1, 2, 3});
  part.mesh.add_face({0, 4, 3});
  part.mesh.add_face({4, 1, 3});
  ImportedPart split = part;
  CleanReport told, done;
  clean(part, {}, told);
  EXPECT_EQ(told.on_edges, 1U);
  EXPECT_EQ(part.mesh.face_count(), 5U) << "nobody asked for it";
  ASSERT_EQ(told.messages().size(), 1U);
  EXPECT_EQ(told.messages()[0].code, w_t_joints);
  EXPECT_NE(told.messages()[0].remedy.find("--repair"), std::string::npos);
  clean(split, {.split_edges = true}, done);
  EXPECT_EQ(done.split_edges, 1U);
  EXPECT_EQ(split.mesh.face_count(), 6U);
  const auto built = test::must(Polyhedron::build(split.mesh));
  EXPECT_EQ(built->topology().border_loop_count(), 0U);
  // A corner beside an edge, and one whose faces do not run along it, are no T-joints.
  ImportedPart apart;
  apart.mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 0, 0}, {0, -3, 0}, {3, -3, 0}};
  apart.mesh.add_face({0, 1, 2});
  apart.mesh.add_face({3, 4, 5});
  CleanReport quiet;
  clean(apart, {.split_edges = true}, quiet);
  EXPECT_EQ(quiet.split_edges, 0U);
}

TEST(CleanPart, TheFlatAndTheCollapsedTriangleOfAnStlAreDropped) {
  auto scene = test::must(read_scene_file(test::case_file("stl_one_flat_triangle.stl")));
  ImportedPart part = std::move(scene.value().parts.at(0));
  CleanReport report;
  clean(part, {}, report);
  EXPECT_EQ(report.flat, 1U);
  ASSERT_EQ(scene->warnings.size(), 1U);
  EXPECT_EQ(scene->warnings[0].code, w_degenerate_triangles);
  const auto built = test::must(Polyhedron::build(part.mesh));
  EXPECT_EQ(built->vertex_count(), 8U);
  EXPECT_EQ(built->face_count(), 12U);
}

}  // namespace
}  // namespace hariko

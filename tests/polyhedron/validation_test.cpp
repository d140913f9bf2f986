#include "core/polyhedron/validation.hpp"

#include <limits>
#include <numbers>
#include <string>

#include "core/polyhedron/polyhedron.hpp"
#include "core/polyhedron/repair.hpp"
#include "tests/support/random_polyhedra.hpp"

namespace hariko::test {
namespace {

/// "CODE element", one a message.
using Findings = std::vector<std::string>;

std::string finding(const Message& message) {
  return std::string(message.code.name) +
         (message.element.kind == Element::Kind::none ? "" : " " + to_string(message.element));
}

/// Also checks what holds for every message, and that building agrees with validation.
Findings findings(const PolygonMesh& mesh) {
  const std::vector<Message> messages = validate(mesh);
  Findings out;
  const Message* first_error = nullptr;
  const Message* first_connectivity_error = nullptr;
  for (const Message& message : messages) {
    out.push_back(finding(message));
    EXPECT_FALSE(message.text.empty()) << out.back();
    EXPECT_FALSE(message.remedy.empty()) << out.back();
    EXPECT_EQ(message.text.back(), '.') << message.text;
    EXPECT_EQ(message.code.name.starts_with("E_"), message.severity == Severity::error) << out.back();
    if (message.severity != Severity::error) continue;
    if (!first_error) first_error = &message;
    if (!first_connectivity_error && message.code != e_nonfinite) first_connectivity_error = &message;
  }
  const auto polyhedron = Polyhedron::build(mesh);
  EXPECT_EQ(polyhedron.ok(), first_error == nullptr);
  if (!polyhedron.ok() && first_error) {
    EXPECT_EQ(finding(polyhedron.error()), finding(*first_error));
  }
  const auto topology = HalfEdgeMesh::build(mesh);
  EXPECT_EQ(topology.ok(), first_connectivity_error == nullptr);
  if (!topology.ok() && first_connectivity_error) {
    EXPECT_EQ(finding(topology.error()), finding(*first_connectivity_error));
  }
  return out;
}

PolygonMesh single_face(const std::vector<Vector3>& corners) {
  PolygonMesh mesh;
  mesh.positions = corners;
  std::vector<Index> face(corners.size());
  for (std::size_t i = 0; i < face.size(); ++i) face[i] = static_cast<Index>(i);
  mesh.add_face(face);
  return mesh;
}

TEST(ValidationErrors, GoodMeshesHaveNone) {
  for (const PolygonMesh& mesh :
       {cube(), octahedron(), prism(3), prism(12), torus(8, 4), grid(3, 3), genus_box(6)})
    EXPECT_EQ(findings(mesh), Findings{});
}

TEST(ValidationErrors, NonFinite) {
  PolygonMesh mesh = cube();
  mesh.positions[2].x() = std::numeric_limits<double>::quiet_NaN();
  mesh.positions[5].z() = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(findings(mesh), (Findings{"E_NONFINITE vertex 2", "E_NONFINITE vertex 5"}));
}

TEST(ValidationErrors, NoFaces) {
  EXPECT_EQ(findings(PolygonMesh{}), Findings{"E_NO_FACES"});
  PolygonMesh points;
  points.positions.assign(3, Vector3::Zero());
  EXPECT_EQ(findings(points), Findings{"E_NO_FACES"});
}

TEST(ValidationErrors, IndexRange) {
  PolygonMesh mesh = cube();
  mesh.face_vertices[mesh.face_offsets[3]] = 8;
  mesh.face_vertices[mesh.face_offsets[4] + 2] = no_index;
  EXPECT_EQ(findings(mesh), (Findings{"E_INDEX_RANGE face 3", "E_INDEX_RANGE face 4"}));
  EXPECT_NE(validate(mesh)[0].text.find("vertex 8"), std::string::npos);
}

TEST(ValidationErrors, FaceTooSmall) {
  PolygonMesh mesh = cube();
  mesh.add_face({0, 1});
  mesh.add_face({2});
  mesh.add_face(std::span<const Index>{});
  EXPECT_EQ(findings(mesh),
            (Findings{"E_FACE_TOO_SMALL face 6", "E_FACE_TOO_SMALL face 7", "E_FACE_TOO_SMALL face 8"}));
}

TEST(ValidationErrors, FaceRepeatedVertex) {
  PolygonMesh mesh = cube();
  mesh.add_face({0, 1, 0});
  EXPECT_EQ(findings(mesh), Findings{"E_FACE_REPEATED_VERTEX face 6"});
  // Faces of more than eight sides take another path.
  PolygonMesh large = prism(12);
  large.face_vertices[5] = large.face_vertices[0];
  EXPECT_EQ(findings(large), Findings{"E_FACE_REPEATED_VERTEX face 0"});
}

TEST(ValidationErrors, EdgeUsedTwiceInOneDirection) {
  PolygonMesh mesh = grid(2, 1);
  std::swap(mesh.face_vertices[mesh.face_offsets[1] + 1], mesh.face_vertices[mesh.face_offsets[1] + 3]);
  EXPECT_EQ(findings(mesh), Findings{"E_EDGE_NONMANIFOLD_OR_FLIPPED edge 1-4"});
}

TEST(ValidationErrors, EdgeWithThreeFaces) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  for (Index wing : {2U, 3U, 4U}) mesh.add_face({0, 1, wing});
  EXPECT_EQ(findings(mesh), Findings{"E_EDGE_NONMANIFOLD_OR_FLIPPED edge 0-1"});
  EXPECT_NE(validate(mesh)[0].text.find("3 faces"), std::string::npos);
}

TEST(ValidationErrors, VertexNonManifold) {
  // Two cubes that touch in one corner.
  const PolygonMesh mesh = weld(together(cube(), cube(), {2, 2, 2}), 0);
  EXPECT_EQ(findings(mesh), Findings{"E_VERTEX_NONMANIFOLD vertex 6"});
  EXPECT_NE(validate(mesh)[0].text.find("2 separate fans"), std::string::npos);
}

TEST(ValidationErrors, OpenFansThatTouch) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  mesh.add_face({0, 1, 2});
  mesh.add_face({0, 3, 4});
  EXPECT_EQ(findings(mesh), Findings{"E_VERTEX_NONMANIFOLD vertex 0"});
}

TEST(ValidationErrors, AllAreReportedInTheOrderOfTheCodes) {
  PolygonMesh mesh = together(cube(), grid(2, 1), {9, 0, 0});
  mesh.positions[3].x() = std::nan("");
  mesh.add_face({0, 0, 1});
  mesh.add_face({0, 99, 1});
  mesh.add_face({1});
  const Index flipped = mesh.face_offsets[7];
  std::swap(mesh.face_vertices[flipped + 1], mesh.face_vertices[flipped + 3]);
  EXPECT_EQ(findings(mesh),
            (Findings{"E_NONFINITE vertex 3", "E_INDEX_RANGE face 9", "E_FACE_TOO_SMALL face 10",
                      "E_FACE_REPEATED_VERTEX face 8", "E_EDGE_NONMANIFOLD_OR_FLIPPED edge 9-12"}));
}

TEST(ValidationErrors, LimitIsPerCodeAndSaysHowManyMore) {
  PolygonMesh mesh = cube();
  for (int i = 0; i < 10; ++i) mesh.add_face({0, 1});
  for (int i = 0; i < 2; ++i) mesh.add_face({0, 0, 1});
  const std::vector<Message> messages = validate(mesh, 3);
  ASSERT_EQ(messages.size(), 5U);
  EXPECT_EQ(messages[2].element, element_of(FaceId{8}));
  EXPECT_NE(messages[2].text.find("7 more"), std::string::npos);
  EXPECT_EQ(messages[4].text.find("more like"), std::string::npos) << messages[4].text;
  EXPECT_TRUE(validate(mesh, 0).empty());
}

TEST(ValidationErrors, AnyGarbageIsJudgedAlikeByBuildAndValidate) {
  for_random(301, 3000, [](std::mt19937_64& rng) {
    PolygonMesh mesh;
    const int vertices = uniform_int(rng, 0, 8), faces = uniform_int(rng, 0, 8);
    for (int v = 0; v < vertices; ++v) mesh.positions.push_back(random_vector(rng).array().round());
    for (int f = 0; f < faces; ++f) {
      std::vector<Index> face;
      for (int i = uniform_int(rng, chance(rng, 0.9) ? 3 : 0, 5); i > 0; --i)
        face.push_back(
            static_cast<Index>(uniform_int(rng, 0, chance(rng, 0.98) ? std::max(vertices - 1, 0) : 9)));
      mesh.add_face(face);
    }
    findings(mesh);
  });
}

TEST(ValidationErrors, DamagedMeshesAreJudgedAlikeByBuildAndValidate) {
  for_random(302, 1000, [](std::mt19937_64& rng) {
    PolygonMesh mesh = random_polyhedron(rng);
    for (int i = uniform_int(rng, 1, 3); i > 0; --i)
      mesh.face_vertices[rng() % mesh.face_vertices.size()] =
          static_cast<Index>(rng() % mesh.positions.size());
    findings(mesh);
  });
}

TEST(ValidationWarnings, IsolatedVertex) {
  PolygonMesh mesh = cube();
  mesh.positions.emplace_back(1, 1, 1);  // not a duplicate: it is ignored
  EXPECT_EQ(findings(mesh), Findings{"W_ISOLATED_VERTEX vertex 8"});
}

PolygonMesh turned(const PolygonMesh& mesh) {
  PolygonMesh out;
  out.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    out.add_face(std::vector<Index>(face.rbegin(), face.rend()));
  }
  return out;
}

TEST(ValidationWarnings, InsideOutIsPerClosedComponent) {
  EXPECT_EQ(findings(turned(cube())), Findings{"W_INSIDE_OUT face 0"});
  EXPECT_EQ(findings(together(cube(), turned(octahedron()), {9, 0, 0})), Findings{"W_INSIDE_OUT face 6"});
  EXPECT_EQ(findings(together(turned(cube()), turned(grid(2, 2)), {9, 0, 0})),
            Findings{"W_INSIDE_OUT face 0"});
}

TEST(ValidationWarnings, InsideOutFarFromZero) {
  for_random(304, 20, [](std::mt19937_64& rng) {
    PolygonMesh mesh = turned(cube());
    const Vector3 shift = random_vector(rng, 1e9);
    for (Vector3& p : mesh.positions) p = 0.3 * p + shift;
    EXPECT_EQ(findings(mesh), Findings{"W_INSIDE_OUT face 0"});
    EXPECT_EQ(findings(turned(mesh)), Findings{});
  });
}

/// Two flat sheets side by side, whose corners 1 and 3, 4 and 6 lie at the same places.
PolygonMesh sheets_side_by_side() {
  PolygonMesh mesh = together(grid(1, 1), grid(1, 1), {2, 0, 0});
  for (Vector3& p : mesh.positions) p.z() = 0;
  return mesh;
}

TEST(ValidationWarnings, DuplicateVertexOnBorders) {
  PolygonMesh even = sheets_side_by_side();
  EXPECT_EQ(findings(even), (Findings{"W_DUPLICATE_VERTEX vertex 4", "W_DUPLICATE_VERTEX vertex 6"}));
  EXPECT_NE(validate(even)[0].text.find("vertex 1"), std::string::npos);
  // Nearly the same place, relative to the size.
  even.positions[4].x() += 1e-13;
  EXPECT_EQ(findings(even), (Findings{"W_DUPLICATE_VERTEX vertex 4", "W_DUPLICATE_VERTEX vertex 6"}));
  even.positions[4].x() += 1e-10;
  EXPECT_EQ(findings(even), Findings{"W_DUPLICATE_VERTEX vertex 6"});
}

TEST(ValidationWarnings, ClosedPartsThatTouchAreNoDuplicates) {
  for (const Vector3& step : {Vector3(2, 2, 2), Vector3(2, 2, 0), Vector3(2, 0, 0)})
    EXPECT_EQ(findings(together(cube(), cube(), step)), Findings{}) << step.transpose();
  // Nor is a body that touches itself: a slab on two feet that meet along an edge.
  const PolygonMesh arch = cells(2, 2, 2, [](int x, int y, int z) { return z == 1 || x == y; });
  ASSERT_FALSE(HalfEdgeMesh::build(arch).ok());
  const auto apart = separate_bodies(arch);
  ASSERT_TRUE(apart.has_value());
  ASSERT_GT(apart->mesh.positions.size(), arch.positions.size());
  EXPECT_EQ(findings(apart->mesh), Findings{});
  // Two cubes that touch along a face: a weld closes nothing while one of them is closed there; the borders
  // of two open ones meet.
  const PolygonMesh open_right = without_face(cube(), 3), open_left = without_face(cube(), 5);
  EXPECT_EQ(findings(together(open_right, cube(), {2, 0, 0})), Findings{});
  EXPECT_EQ(findings(together(open_right, open_left, {2, 0, 0})).size(), 4U);
}

TEST(ValidationWarnings, ZeroEdge) {
  PolygonMesh mesh = grid(3, 3);
  mesh.positions[6] = mesh.positions[5];
  EXPECT_EQ(findings(mesh), Findings{"W_ZERO_EDGE edge 5-6"});
  mesh = grid(3, 3);
  mesh.positions[2] = mesh.positions[1];  // on the border
  EXPECT_EQ(findings(mesh), (Findings{"W_DUPLICATE_VERTEX vertex 2", "W_ZERO_EDGE edge 1-2"}));
}

TEST(ValidationWarnings, ConcaveFace) {
  EXPECT_EQ(findings(single_face({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}})),
            Findings{"W_CONCAVE_FACE face 0"});
  // Just inside and just outside 1e-4 of the area (a square of area 4 with a fifth corner near a side's
  // middle).
  const auto dent = [](double depth) {
    return single_face({{0, 0, 5}, {1, depth, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}});
  };
  EXPECT_EQ(findings(dent(-0.1)), Findings{});
  EXPECT_EQ(findings(dent(0)), Findings{});
  EXPECT_EQ(findings(dent(3e-4)), Findings{});  // triangle 3e-4 of 4
  EXPECT_EQ(findings(dent(5e-4)), Findings{"W_CONCAVE_FACE face 0"});
}

TEST(ValidationWarnings, FacesThatAreNotPlanarAreJudgedInTheirMeanPlane) {
  EXPECT_EQ(findings(single_face({{0, 0, 0.3}, {1, 0, -0.3}, {1, 1, 0.3}, {0, 1, -0.3}})), Findings{});
  EXPECT_EQ(findings(single_face({{0, 0, 0.1}, {2, 0, -0.1}, {2, 2, 0.1}, {1, 0.5, -0.1}})),
            Findings{"W_CONCAVE_FACE face 0"});
}

TEST(ValidationWarnings, SelfCrossingFace) {
  // Symmetric bow tie: its mean plane has no direction of its own. Then an uneven one, and a star.
  EXPECT_EQ(findings(single_face({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}})),
            Findings{"W_SELF_CROSSING_FACE face 0"});
  EXPECT_EQ(findings(single_face({{0, 0, 0}, {3, 3, 0}, {1, 0, 0}, {0, 1, 0}})),
            Findings{"W_SELF_CROSSING_FACE face 0"});
  std::vector<Vector3> star;
  for (int i = 0; i < 5; ++i)
    star.emplace_back(std::cos(i * 4 * std::numbers::pi / 5), 1, std::sin(i * 4 * std::numbers::pi / 5));
  EXPECT_EQ(findings(single_face(star)), Findings{"W_SELF_CROSSING_FACE face 0"});
}

TEST(ValidationWarnings, FaceWithinALineIsNoShapeWarning) {
  EXPECT_EQ(findings(single_face({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {2, 0, 0}})), Findings{});
}

TEST(ValidationWarnings, ManySidesAreNoReason) {
  EXPECT_EQ(findings(prism(13)), Findings{});
  EXPECT_EQ(findings(prism(128)), Findings{});
}

TEST(ValidationWarnings, InnerValence2) {
  // A triangle over a quadrilateral whose extra corner lies on two edges only: a bent sheet closed to a
  // pillow.
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0.2}, {1, 1, 0}, {0, 1, 0.2}};
  mesh.add_face({0, 1, 2, 3});
  mesh.add_face({3, 2, 1, 0});
  const Findings expected{"W_VALENCE_2 vertex 0", "W_VALENCE_2 vertex 1", "W_VALENCE_2 vertex 2",
                          "W_VALENCE_2 vertex 3"};
  Findings found = findings(mesh);
  std::erase_if(found, [](const std::string& f) { return f.starts_with("W_INSIDE_OUT"); });
  EXPECT_EQ(found, expected);
  EXPECT_EQ(findings(grid(1, 1)), Findings{});  // border vertices with two edges are common
}

TEST(ValidationWarnings, OfAPolyhedronUseItsIds) {
  PolygonMesh mesh = together(sheets_side_by_side(), turned(cube()), {9, 0, 0});
  std::vector<VertexId> vertex_ids;
  std::vector<FaceId> face_ids;
  for (Index v = 0; v < 16; ++v) vertex_ids.push_back({10 * v});
  for (Index f = 0; f < 8; ++f) face_ids.push_back({5 * f});
  const Polyhedron polyhedron = Polyhedron::build(mesh, vertex_ids, face_ids).value();
  const std::vector<Message> messages = warnings_of(polyhedron);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(finding(messages[0]), "W_INSIDE_OUT face 10");
  EXPECT_EQ(finding(messages[1]), "W_DUPLICATE_VERTEX vertex 40");
  EXPECT_NE(messages[1].text.find("vertex 10"), std::string::npos);
  EXPECT_EQ(finding(messages[2]), "W_DUPLICATE_VERTEX vertex 60");
}

TEST(ValidationWarnings, PerturbedRandomPolyhedraHaveOnlyHarmlessOnes) {
  for_random(303, 200, [](std::mt19937_64& rng) {
    for (const std::string& f : findings(random_polyhedron(rng)))
      EXPECT_TRUE(f.starts_with("W_CONCAVE_FACE")) << f;
  });
}

TEST(Validation, LargeInputTakesNoQuadraticTime) {
  // 60,000 corners in one face; none of its notches is 1e-4 of the area.
  std::vector<Vector3> corners;
  const int n = 60000;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n, radius = i % 2 ? 1 : 0.9;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  EXPECT_EQ(findings(single_face(corners)), Findings{});
  // Many vertices at one place.
  PolygonMesh heap = grid(200, 200);
  for (Vector3& p : heap.positions) p = Vector3::Ones();
  EXPECT_EQ(validate(heap, 1).size(), 2U);
  // Many bodies beside each other, of which every second one is inside out.
  const PolygonMesh body = cube(), wrong = turned(cube());
  PolygonMesh bodies;
  constexpr int rows = 250;
  for (int k = 0; k < rows * rows; ++k) {
    const PolygonMesh& part = k % 2 == 0 ? body : wrong;
    const auto first = static_cast<Index>(bodies.positions.size());
    const Vector3 place(3 * (k % rows), 3 * (k / rows), 0);
    for (const Vector3& p : part.positions) bodies.positions.push_back(p + place);
    for (std::size_t f = 0; f < part.face_count(); ++f) {
      std::vector<Index> face(part.face(f).begin(), part.face(f).end());
      for (Index& v : face) v += first;
      bodies.add_face(face);
    }
  }
  const std::vector<Message> messages = validate(bodies, 1);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].code, w_inside_out);
  EXPECT_NE(messages[0].text.find("(31249 more like this.)"), std::string::npos) << messages[0].text;
}

}  // namespace
}  // namespace hariko::test

#include <set>

#include "core/document/file.hpp"
#include "core/exchange/mesh_file.hpp"
#include "core/modeling/surfacing/local_edit.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

class Info : public ProgramTest {
 protected:
  Json inspect(const std::string& file, int exit_code = 0) {
    const Outcome result = run("info '" + file + "' --json");
    EXPECT_EQ(result.exit_code, exit_code) << result.error;
    return result.object();
  }
};

std::set<std::string> codes(const Json& object) {
  std::set<std::string> out;
  for (const Json& message : object["messages"]) out.insert(message["code"].get<std::string>());
  return out;
}

TEST_F(Info, HasExactlyTheDocumentedKeys) {
  const Json cube = inspect(golden("cube.obj"));
  std::set<std::string> keys;
  for (const auto& [key, value] : cube.items()) keys.insert(key);
  EXPECT_EQ(keys, (std::set<std::string>{"name",
                                         "kind",
                                         "vertices",
                                         "edges",
                                         "faces",
                                         "patches",
                                         "components",
                                         "genus",
                                         "boundary_loops",
                                         "area",
                                         "volume",
                                         "bending",
                                         "largest_gap",
                                         "largest_normal_jump",
                                         "rms_curvature_jump",
                                         "gauss_range",
                                         "mean_range",
                                         "degenerate_samples",
                                         "folded_samples",
                                         "messages",
                                         "milliseconds"}));
  for (const char* step : {"read", "validate", "rebuild", "measures", "continuity", "statistics"})
    EXPECT_GE(cube["milliseconds"][step].get<double>(), 0) << step;
}

TEST_F(Info, OfAClosedObject) {
  const Json cube = inspect(golden("cube.obj"));
  EXPECT_EQ(cube["name"], "cube");
  EXPECT_EQ(cube["kind"], "polyhedron");
  EXPECT_EQ(cube["vertices"], 8);
  EXPECT_EQ(cube["edges"], 12);
  EXPECT_EQ(cube["faces"], 6);
  EXPECT_EQ(cube["patches"], 24);
  EXPECT_EQ(cube["components"], 1);
  EXPECT_EQ(cube["genus"], 0);
  EXPECT_EQ(cube["boundary_loops"], 0);
  EXPECT_NEAR(cube["area"].get<double>(), 37.1460054052, 1e-9);
  EXPECT_NEAR(cube["bending"].get<double>(), 25.2341142265, 1e-9);
  const double area = cube["area"], volume = cube["volume"];
  EXPECT_LT(36 * 3.14159265 * volume * volume, area * area * area);  // isoperimetric
  EXPECT_GT(volume, 20);
  EXPECT_LE(cube["largest_gap"].get<double>(), 1e-13);
  EXPECT_LE(cube["largest_normal_jump"].get<double>(), 1e-10);
  EXPECT_LT(cube["gauss_range"][0].get<double>(), cube["gauss_range"][1].get<double>());
  EXPECT_GT(cube["mean_range"][0].get<double>(), 0) << "convex";
  EXPECT_EQ(cube["degenerate_samples"], 0);
  EXPECT_EQ(cube["folded_samples"], 0);
  EXPECT_TRUE(cube["messages"].empty());
}

TEST_F(Info, OfOpenAndKnottedObjects) {
  const Json open = inspect(golden("fig2_open.obj"));
  EXPECT_TRUE(open["volume"].is_null());
  EXPECT_EQ(open["boundary_loops"], 1);
  EXPECT_EQ(open["genus"], 0);
  EXPECT_NEAR(open["rms_curvature_jump"].get<double>(), 0.0244850063, 1e-9);
  const Json genus3 = inspect(golden("genus3.obj"));
  EXPECT_EQ(genus3["genus"], 3);
  EXPECT_NEAR(genus3["bending"].get<double>() / 221.99, 1, 0.001);
  EXPECT_EQ(inspect(golden("torus.obj"))["genus"], 1);
}

TEST_F(Info, WarningsAloneGiveZero) {
  // Imports have their concave faces cut; this document does not.
  const auto mesh = must(read_mesh_file(golden("concave.obj")));
  ASSERT_TRUE(save_document(document_from_mesh(mesh->mesh, "block").value(), path("block.hariko")).ok());
  EXPECT_FALSE(codes(inspect(golden("concave.obj"))).count("W_FOLD"));
  const Json concave = inspect(path("block.hariko"));
  EXPECT_TRUE(codes(concave).count("W_CONCAVE_FACE"));
  EXPECT_TRUE(codes(concave).count("W_FOLD"));
  const Json message = concave["messages"][0];
  EXPECT_EQ(message.size(), 4U);
  EXPECT_EQ(message["severity"], "warning");
  EXPECT_EQ(message["element"], "face 0");
  EXPECT_FALSE(message["text"].get<std::string>().empty());
}

TEST_F(Info, MeshThatMakesNoPolyhedronIsExplained) {
  // Three faces at one edge.
  write_text(path("fin.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  const Json fin = inspect(path("fin.obj"), 1);
  EXPECT_TRUE(codes(fin).count("E_EDGE_NONMANIFOLD_OR_FLIPPED")) << fin;
  EXPECT_EQ(fin["vertices"], 5);
  EXPECT_TRUE(fin["area"].is_null());
  const Outcome text = run("info '" + path("fin.obj") + "'");
  EXPECT_EQ(text.exit_code, 1);
  EXPECT_NE(text.out.find("E_EDGE_NONMANIFOLD_OR_FLIPPED"), std::string::npos);
}

TEST_F(Info, FileThatCannotBeReadGivesAnEmptyList) {
  const Outcome missing = run("info " + path("missing.obj") + " --json");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(missing.json()["objects"], Json::array());
  EXPECT_NE(missing.error.find("E_FILE_OPEN"), std::string::npos);
}

TEST_F(Info, DocumentInItsOwnUnitAndScale) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (const auto& face : {std::array<Index, 4>{0, 2, 3, 1},
                           {4, 5, 7, 6},
                           {0, 1, 5, 4},
                           {1, 3, 7, 5},
                           {3, 2, 6, 7},
                           {2, 0, 4, 6}})
    mesh.add_face(face);
  auto document = must(document_from_mesh(mesh, "block"));
  Document scaled = *document;
  Object object = *scaled.objects[0];
  object.transform.scale = 2;
  object.transform.translation = {1e6, 0, 0};
  scaled.objects[0] = std::make_shared<const Object>(object);
  ASSERT_TRUE(save_document(scaled, path("block.hariko")).ok());
  const Json block = inspect(path("block.hariko"));
  EXPECT_EQ(block["name"], "block");
  EXPECT_NEAR(block["area"].get<double>(), 4 * 36.2953247283, 1e-8);
  EXPECT_NEAR(block["bending"].get<double>(), 27.0618627308, 1e-9);
}

TEST_F(Info, ListsDimensions) {
  const auto mesh = must(read_mesh_file(golden("cube.obj")));
  Document document = document_from_mesh(mesh->mesh, "block").value();
  const ObjectId id = document.objects[0]->id;
  const auto corner = [&](std::uint32_t vertex) { return VertexAnchor{id, VertexId{vertex}}; };
  document.dimensions = Dimensions{
      {{1}, DimensionKind::distance, {corner(0), corner(1)}, Vector3::Zero()},
      {{2}, DimensionKind::angle, {corner(1), corner(0), SpaceAnchor{{-1, -1, 5}}}, Vector3::Zero()},
      {{3}, DimensionKind::radius, {PatchAnchor{id, element_of(FaceId{0}), 1, {0.3, 0.3}}}, Vector3::Zero()},
      {{4}, DimensionKind::distance, {corner(0), corner(99)}, Vector3::Zero()}};
  ASSERT_TRUE(save_document(document, path("block.hariko")).ok());
  const Outcome result = succeed("info '" + path("block.hariko") + "' --json");
  const Json list = result.json()["dimensions"];
  ASSERT_EQ(list.size(), 4U);
  EXPECT_EQ(list[0]["kind"], "distance");
  EXPECT_DOUBLE_EQ(list[0]["value"].get<double>(), 2);
  EXPECT_EQ(list[0]["anchors"][1], "vertex 1 of block");
  EXPECT_EQ(list[0]["points"].size(), 2U);
  EXPECT_FALSE(list[0].contains("radii"));
  EXPECT_NEAR(list[1]["value"].get<double>(), 90, 1e-9);
  EXPECT_EQ(list[1]["anchors"][2], "(-1, -1, 5)");
  EXPECT_EQ(list[2]["radii"].size(), 2U);
  EXPECT_GT(list[2]["value"].get<double>(), 0.5);
  EXPECT_TRUE(list[3]["value"].is_null()) << "the file names a vertex that is not there";
  const Outcome text = run("info '" + path("block.hariko") + "'");
  EXPECT_NE(text.out.find("dimensions            4\n"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("distance              2 mm  (vertex 0 of block - vertex 1 of block)\n"),
            std::string::npos)
      << text.out;
  EXPECT_NE(text.out.find("angle                 90 degrees"), std::string::npos);
  EXPECT_EQ(run("info '" + golden("cube.obj") + "'").out.find("dimensions"), std::string::npos);
}

/// A local edit (kuriyama.md section 10): tangents round a vertex are fixed, then it moves.
TEST_F(Info, CountsThePatchesThatALocalEditLeavesAlone) {
  for (const char* mode : {"paper", "target", "fair", "g2"}) {
    SCOPED_TRACE(mode);
    const auto mesh = must(read_mesh_file(golden("torus.obj")));
    Document before = document_from_mesh(mesh->mesh, "torus").value();
    Object object = *before.objects[0];
    PolyhedronSource source = *object.polyhedron();
    const VertexId moved = source.polyhedron.vertex_id(7);
    const auto around = vertices_around(source.polyhedron, std::span(&moved, 1));
    source = freeze_tangents(source, around).value();
    const auto with = [&](const PolyhedronSource& changed) {
      Document out = before;
      object.source = changed;
      out.objects[0] = std::make_shared<const Object>(object);
      return out;
    };
    ASSERT_TRUE(save_document(with(source), path("before.hariko")).ok());
    const Index v = source.polyhedron.find(moved);
    const Vector3 to = source.polyhedron.position(v) + Vector3(0.1, 0.2, 0.1);
    source.polyhedron = source.polyhedron.with_positions(std::span(&v, 1), std::span(&to, 1)).value();
    ASSERT_TRUE(save_document(with(source), path("after.hariko")).ok());

    // Patches of faces that share a vertex with those round the moved one.
    const HalfEdgeMesh& topology = source.polyhedron.topology();
    std::size_t touched = 0;
    for (Index f = 0; f < topology.face_count(); ++f) {
      const auto corners = topology.face_vertices(f);
      if (std::any_of(corners.begin(), corners.end(), [&](Index corner) {
            return std::find(around.begin(), around.end(), source.polyhedron.vertex_id(corner)) !=
                   around.end();
          }))
        touched += topology.side_count(f);
    }
    const std::string files = "info '" + path("after.hariko") + "' --json --mode " + mode + " --against '";
    const Json against = run(files + path("before.hariko") + "'").object()["against"];
    EXPECT_EQ(against["patches"], topology.half_edge_count());
    EXPECT_EQ(against["unmatched"], 0);
    EXPECT_EQ(against["unchanged"].get<std::size_t>() + against["changed"].get<std::size_t>(),
              topology.half_edge_count());
    EXPECT_GT(against["largest_distance"].get<double>(), 1e-3);
    EXPECT_GT(against["changed"].get<std::size_t>(), 0U);
    if (std::string(mode) == "paper" || std::string(mode) == "target") {
      EXPECT_LE(against["changed"].get<std::size_t>(), touched);
      EXPECT_LT(touched, topology.half_edge_count());
    }
    const Json itself = run(files + path("after.hariko") + "'").object()["against"];
    EXPECT_EQ(itself["unchanged"], topology.half_edge_count());
    EXPECT_EQ(itself["largest_distance"], 0.0);
  }
  const Outcome missing = run("info '" + path("after.hariko") + "' --against '" + path("none.hariko") + "'");
  EXPECT_EQ(missing.exit_code, 1);
  const Json other =
      run("info '" + golden("cube.obj") + "' --json --against '" + golden("octahedron.obj") + "'")
          .object()["against"];
  EXPECT_EQ(other["unmatched"].get<int>() + other["changed"].get<int>(), 24);
}

TEST_F(Info, OnATerminalTheErrorStreamShowsWhatIsGoingOn) {
  write_text(path("grid.obj"),
             bumpy_grid(60));  // more than a tenth of a second, after which the line appears
  const std::string shown = shown_on_terminal("info '" + path("grid.obj") + "'");
  EXPECT_NE(shown.find("grid: measuring"), std::string::npos) << shown;
  EXPECT_TRUE(shown.ends_with("\r\033[K")) << "the line goes when the work is done";
  EXPECT_TRUE(read_text(path("stdout.txt")).starts_with("name")) << "the results are elsewhere";
  EXPECT_EQ(run("info '" + path("grid.obj") + "'").error, "") << "no line where nobody looks";
}

TEST_F(Info, TextForPeople) {
  const Outcome text = succeed("info " + golden("cube.obj"));
  EXPECT_NE(text.out.find("boundary loops"), std::string::npos);
  EXPECT_NE(text.out.find("polyhedron"), std::string::npos);
}

}  // namespace
}  // namespace hariko::test

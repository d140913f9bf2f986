// `hariko mesh`: counts, errors, files of patches, refusals.

#include <algorithm>
#include <filesystem>

#include "core/document/edits/edit_objects.hpp"
#include "core/document/file.hpp"
#include "core/exchange/read_patches.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/must.hpp"

namespace hariko::test {
namespace {

class Mesh : public ProgramTest {};

constexpr const char* pipe_patch =
    "1\n3 3\n"
    "2 0 0\n2 2 0\n2 4 0\n2 6 0\n"
    "2 0 1.1\n2 2 1.1\n2 4 1.1\n2 6 1.1\n"
    "1.1 0 2\n1.1 2 2\n1.1 4 2\n1.1 6 2\n"
    "0 0 2\n0 2 2\n0 4 2\n0 6 2\n";

TEST_F(Mesh, JsonTellsCountsAndErrors) {
  const Outcome result =
      succeed("mesh " + golden("cube.obj") + " " + path("out.obj") + " --distance 0.01 --json");
  const Json json = result.json();
  ASSERT_TRUE(json.is_object()) << result.out;
  const Json& object = json["objects"].at(0);
  EXPECT_GT(object["facets"].get<int>(), 50);
  EXPECT_EQ(object["facets"], json["facets"]);
  EXPECT_LE(object["distance"]["bound"].get<double>(), 0.01);
  EXPECT_LE(object["distance"]["measured"].get<double>(), object["distance"]["bound"].get<double>());
  EXPECT_GT(object["normal_angle"]["measured"].get<double>(), 0);
  EXPECT_TRUE(object["luminance"].is_null());
  const std::string text = read_text(path("out.obj"));
  EXPECT_EQ(std::size_t(std::count(text.begin(), text.end(), 'f')), object["facets"].get<std::size_t>());
}

TEST_F(Mesh, FilesOfPatches) {
  write_text(path("pipe.bpt"), pipe_patch);
  const Outcome plain =
      succeed("mesh " + path("pipe.bpt") + " " + path("a.stl") + " --distance 0.01 --split gauss --json");
  const int facets = plain.json()["facets"].get<int>();
  EXPECT_GT(facets, 10);
  EXPECT_EQ(std::filesystem::file_size(path("a.stl")), 84U + 50U * std::size_t(facets));
  // The same by numbers of points.
  std::string indexed = "1\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n16\n", points = pipe_patch;
  points = points.substr(points.find("3 3\n") + 4);
  std::replace(points.begin(), points.end(), ' ', ',');
  write_text(path("indexed.bpt"), indexed + points);
  const Outcome second =
      run("mesh " + path("indexed.bpt") + " " + path("b.ply") + " --distance 0.01 --split gauss --json");
  EXPECT_EQ(second.json()["facets"].get<int>(), facets) << second.error;
  // A patch that bends one way only begins with cells across.
  const Outcome cells =
      run("mesh " + path("pipe.bpt") + " " + path("d.ply") + " --distance 0.01 --start cells --json");
  EXPECT_LT(cells.json()["facets"].get<int>(), facets / 2) << cells.error;
  EXPECT_LE(cells.json()["objects"].at(0)["distance"]["bound"].get<double>(), 0.01);
  // Rational and of another degree.
  write_text(path("arc.json"),
             R"({"arc": [{"ctrl": [[[1,0,0],[1,0,2]],[[1,1,0],[1,1,2]],[[0,1,0],[0,1,2]]],
                 "weights": [[1,1],[0.70710678118654752,0.70710678118654752],[1,1]]}]})");
  const Outcome rational = run("mesh " + path("arc.json") + " " + path("c.obj") + " --distance 0.001 --json");
  EXPECT_EQ(rational.exit_code, 0) << rational.error;
  EXPECT_EQ(rational.json()["objects"].at(0)["name"], "arc");
  EXPECT_LE(rational.json()["objects"].at(0)["distance"]["bound"].get<double>(), 0.001);
}

/// A quarter of a cylinder of radius 1 and height 2, exact, and a plane of degree 4 by 1 beside it.
constexpr const char* rational_patches =
    R"({"arc": [{"ctrl": [[[1,0,0],[1,0,2]],[[1,1,0],[1,1,2]],[[0,1,0],[0,1,2]]],
        "weights": [[1,1],[0.70710678118654752,0.70710678118654752],[1,1]]},
        {"ctrl": [[[1,0,0],[1,0,2]],[[1,-0.5,0],[1,-0.5,2]],[[1,-1,0],[1,-1,2]],[[1,-1.5,0],[1,-1.5,2]],
        [[1,-2,0],[1,-2,2]]]}]})";

TEST_F(Mesh, PatchesOfAnyDegreeAreObjects) {
  write_text(path("arc.json"), rational_patches);
  const Outcome info = succeed("info " + path("arc.json") + " --json");
  const Json object = info.object();
  EXPECT_EQ(object["kind"], "bezier");
  EXPECT_EQ(object["name"], "arc");
  EXPECT_EQ(object["patches"], 2);
  EXPECT_NEAR(object["area"].get<double>(), 2 * 1.5707963267948966 + 4, 1e-6);
  // Written, read again, meshed from the document as from the file.
  const auto groups = must(read_patch_file(path("arc.json")));
  const auto source = must(BezierSource::from_patches(groups->front().patches));
  const auto made = add_object({}, "arc", Source(*source));
  ASSERT_TRUE(save_document(made.value().document, path("arc.hariko")).ok());
  const Outcome first = run("mesh " + path("arc.json") + " " + path("a.obj") + " --distance 0.001 --json");
  const Outcome second = run("mesh " + path("arc.hariko") + " " + path("b.obj") + " --distance 0.001 --json");
  EXPECT_EQ(first.exit_code, 0) << first.error;
  EXPECT_EQ(second.exit_code, 0) << second.error;
  EXPECT_EQ(first.json()["facets"], second.json()["facets"]);
  EXPECT_LE(second.json()["objects"].at(0)["distance"]["bound"].get<double>(), 0.001);
  EXPECT_EQ(run("export " + path("arc.json") + " " + path("c.stl")).exit_code, 0);
}

TEST_F(Mesh, ErrorsOfEveryFacetAndSample) {
  const Outcome result = succeed("mesh " + golden("cube.obj") + " " + path("out.obj") +
                                 " --normal 15 --json --errors " + path("errors.csv"));
  const Json object = result.json()["objects"].at(0);
  const std::string text = read_text(path("errors.csv"));
  EXPECT_EQ(text.rfind("object,kind,number,facet,x,y,z,distance", 0), 0U);
  std::size_t facets = 0;
  for (std::size_t at = text.find(",facet,"); at != std::string::npos; at = text.find(",facet,", at + 1))
    ++facets;
  EXPECT_EQ(facets, 1 + object["facets"].get<std::size_t>());  // and the head
  const Json& errors = object["errors"];
  EXPECT_NEAR(errors["normal_angle"]["largest"].get<double>(),
              object["normal_angle"]["measured"].get<double>(), 0.5);
  EXPECT_GT(errors["distance"]["largest"].get<double>(), errors["distance"]["mean"].get<double>());
  EXPECT_LE(errors["distance"]["largest"].get<double>(), object["distance"]["bound"].get<double>());
  EXPECT_EQ(errors["distance"]["place"].size(), 3U);
  EXPECT_EQ(run("mesh " + golden("cube.obj") + " " + path("o.obj") + " --normal 15 --errors x.txt").exit_code,
            2);
}

TEST_F(Mesh, ReferenceMeshesAreDecimated) {
  // A flat sheet of 20 x 20 squares that is bent once, at 90 degrees.
  PolygonMesh sheet;
  for (Index j = 0; j <= 20; ++j)
    for (Index i = 0; i <= 20; ++i) sheet.positions.emplace_back(std::min(i, 10U), j, i < 10 ? 0 : i - 10);
  for (Index j = 0; j < 20; ++j)
    for (Index i = 0; i < 20; ++i)
      sheet.add_face({21 * j + i, 21 * j + i + 1, 21 * j + i + 22, 21 * j + i + 21});
  auto source = must(MeshSource::from_mesh(sheet));
  const auto document = must(add_object({}, "sheet", std::move(source).value()));
  ASSERT_TRUE(save_document(document->document, path("sheet.hariko")).ok());
  const Outcome result = succeed("mesh " + path("sheet.hariko") + " " + path("out.obj") +
                                 " --distance 0.01 --json --errors " + path("errors.csv"));
  const Json object = result.json()["objects"].at(0);
  EXPECT_EQ(object["facets"], 4);
  EXPECT_LE(object["distance"]["bound"].get<double>(), 0.01);
  EXPECT_LE(object["errors"]["distance"]["largest"].get<double>(), 1e-9);
}

TEST_F(Mesh, Refusals) {
  const std::string cube = "mesh " + golden("cube.obj") + " ";
  const auto fails = [&](const std::string& arguments, const char* code) {
    const Outcome result = run(arguments);
    EXPECT_EQ(result.exit_code, 1) << arguments;
    EXPECT_NE(result.error.find(code), std::string::npos) << result.error;
  };
  fails(cube + path("o.obj"), "E_MESH_NOTHING");
  fails(cube + path("o.obj") + " --distance 0", "E_MESH_TOLERANCE");
  fails(cube + path("o.obj") + " --distance 1e-12", "E_MESH_TOLERANCE");
  write_text(path("broken.bpt"), "1\n3 3\n0 0 0\n");
  fails("mesh " + path("broken.bpt") + " " + path("o.obj") + " --distance 1", "E_TRUNCATED");
  write_text(path("broken.json"), "{\"a\": [{\"ctrl\": [[[1, 2]]]}]}");
  fails("mesh " + path("broken.json") + " " + path("o.obj") + " --distance 1", "E_PARSE");
  EXPECT_FALSE(std::filesystem::exists(path("o.obj")));
  EXPECT_EQ(run(cube + path("o.txt") + " --distance 1").exit_code, 2);
  EXPECT_EQ(run(cube + path("o.obj") + " --split nothing").exit_code, 2);
  EXPECT_EQ(run(cube + path("o.obj") + " --start nothing").exit_code, 2);
}

}  // namespace
}  // namespace hariko::test

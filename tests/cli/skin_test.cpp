// Skins on the command line: the plain layout, `info`, `evaluate` and the control mesh.

#include <array>
#include <sstream>

#include "tests/cli/program.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

class SkinCommands : public ProgramTest {
 protected:
  static std::string sections(const std::string& name) {
    return test::source_folder() + "/tests/skinning/data/" + name + ".json";
  }
  static Json golden_case(const std::string& name) {
    return Json::parse(read_text(test::source_folder() + "/tests/skinning/data/golden.json"))[name];
  }
};

TEST_F(SkinCommands, EvaluateGivesTheGoldenValues) {
  // Settings that the layout does not give are as in these configurations.
  for (const auto& [name, configuration] : {std::pair("fig9_interior", "fig9_interior/pleat_quads"),
                                            std::pair("car_edited", "car_edited/pleat_fair200")}) {
    SCOPED_TRACE(name);
    const Outcome result = succeed("evaluate " + sections(name));
    const Json got = result.json(), expected = golden_case(configuration);
    for (const char* key : {"vertices", "faces", "edges", "quads", "tris", "ngons", "extraordinary", "euler",
                            "boundary_vertices", "nonmanifold_edges", "crease_edges", "corner_vertices",
                            "regular_faces", "lines"})
      EXPECT_EQ(got[key], expected[key]) << key;
    for (std::size_t s = 0; s < expected["rows"].size(); ++s)
      for (std::size_t q = 0; q < expected["rows"][s].size(); ++q)
        EXPECT_NEAR(got["rows"][s][q].get<double>(), expected["rows"][s][q].get<double>(), 1e-8);
    EXPECT_NEAR(got["limit_cond"].get<double>() / expected["limit_cond"].get<double>(), 1, 0.01);
    for (const Json& miss : got["section_error"]) EXPECT_LT(miss["same_parameter_max"], 1e-10);
    EXPECT_EQ(got["control"]["points"].size(), expected["vertices"]);
    EXPECT_EQ(got["control"]["faces"].size(), expected["faces"]);
    for (const Json& sample : expected["samples"])
      for (const char* key : {"control", "limit"})
        for (std::size_t axis = 0; axis < 3; ++axis)
          EXPECT_NEAR(got["samples"][sample["vertex"].get<std::size_t>()][key][axis].get<double>(),
                      sample[key][axis].get<double>(), 1e-5);
  }
  const Outcome smooth = succeed("evaluate " + test::source_folder() + "/assets/samples/skin_smooth.hariko");
  EXPECT_EQ(smooth.json()["grid"], Json({7, 8}));
  EXPECT_EQ(smooth.json()["params"].size(), 2U) << "one row a section";
}

/// The layout with all positions moved.
Json moved(Json layout, const std::array<double, 3>& by) {
  const auto move = [&](Json& points) {
    for (Json& point : points)
      for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = point[axis].get<double>() + by[axis];
  };
  move(layout["path"]["points"]);
  for (Json& section : layout["sections"]) move(section["points"]);
  return layout;
}

TEST_F(SkinCommands, FarFromZeroIsAsPreciseAsAtZero) {
  const Json far = Json::parse(read_text(test::source_folder() + "/tests/cases/skin_far_from_origin.json"));
  for (const double place : {0.0, 1e3, 1e6}) {
    SCOPED_TRACE(place);
    write_text(path("a.json"), moved(far, {place - 1e6, place - 1e6, place - 1e6}).dump());
    const Outcome result = succeed("info --json " + path("a.json"));
    const Json object = result.object();
    // Pleats of equal cost fall either way, by the last digits of the points.
    EXPECT_NEAR(object["volume"].get<double>(), 14879.3, 0.5);
    EXPECT_EQ(object["degenerate_samples"], 0);
    for (const Json& miss : object["skin"]["section_miss"]) EXPECT_LT(miss.get<double>(), 1e-6);
    const Outcome evaluated = succeed("evaluate " + path("a.json"));
    // Object space: what is far from zero gets a place for its object.
    EXPECT_NEAR(evaluated.json()["control"]["points"][0][2].get<double>(), place > 1e5 ? 0 : place, 100);
    ASSERT_EQ(run("export --control " + path("a.json") + " " + path("a.obj")).exit_code, 0);
    std::istringstream control(read_text(path("a.obj")));
    double x = 0, y = 0, z = 0;
    for (std::string word; control >> word && word != "v";) continue;
    control >> x >> y >> z;
    EXPECT_NEAR(z, place, 100);
  }
}

TEST_F(SkinCommands, InfoTellsHowNearTheSectionsAre) {
  const Outcome result = succeed("info --json " + sections("car_edited"));
  const Json object = result.object(), skin = object["skin"];
  EXPECT_EQ(object["kind"], "skin");
  EXPECT_EQ(object["vertices"], 191);
  EXPECT_EQ(skin["method"], "pleat");
  EXPECT_EQ(skin["sections"], 7);
  const Json expected = golden_case("car_edited/pleat_fair200");
  std::size_t rows = 1;
  for (const Json& strip : expected["rows"]) rows += strip.size() - 1;
  EXPECT_EQ(skin["rows"], rows);
  EXPECT_EQ(skin["extraordinary"], expected["extraordinary"]);
  ASSERT_EQ(skin["section_miss"].size(), 7U);
  for (const Json& miss : skin["section_miss"]) EXPECT_LT(miss, 1e-6);
  EXPECT_NEAR(skin["condition"].get<double>(), 8.85, 0.1);
  EXPECT_EQ(object["largest_gap"], 0.0);
  const Outcome text = run("info " + sections("car_edited"));
  EXPECT_NE(text.out.find("section_miss"), std::string::npos) << text.out;
  // A skin that cannot be made says why.
  Json broken = Json::parse(read_text(sections("fig6a")));
  broken["sections"].erase(1);
  write_text(path("one.json"), broken.dump());
  const Outcome failed = run("info --json '" + path("one.json") + "'");
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_EQ(failed.object()["messages"][0]["code"], "E_FEW_SECTIONS");
}

TEST_F(SkinCommands, SkinsBecomeTrianglesAndPaperAsOtherSurfacesDo) {
  const Outcome mesh = run("mesh " + sections("fig5") + " '" + path("out.obj") + "' --distance 0.01 --json");
  ASSERT_EQ(mesh.exit_code, 0) << mesh.error;
  const Json distance = mesh.json()["objects"].at(0)["distance"];
  EXPECT_LE(distance["bound"].get<double>(), 0.01);
  EXPECT_LE(distance["measured"].get<double>(), distance["bound"].get<double>());
  const Outcome paper =
      succeed("unfold " + sections("fig5") + " '" + path("out.svg") + "' --height 100 --steps 200 --json");
  EXPECT_EQ(paper.json()["overlaps"], 0);
}

TEST_F(SkinCommands, TheControlMeshIsWrittenWithItsCreases) {
  succeed("export --control " + sections("sharp3") + " '" + path("out.obj") + "'");
  const Json expected = golden_case("sharp3/pleat_fair200");
  std::istringstream lines(read_text(path("out.obj")));
  std::string line;
  std::size_t vertices = 0, faces = 0, creases = 0, corners = 0;
  while (std::getline(lines, line)) {
    vertices += line.starts_with("v ");
    faces += line.starts_with("f ");
    creases += line.starts_with("t crease 2/1/0 ");
    corners += line.starts_with("t corner 1/1/0 ");
  }
  EXPECT_EQ(vertices, expected["vertices"]);
  EXPECT_EQ(faces, expected["faces"]);
  EXPECT_EQ(creases, expected["crease_edges"]);
  EXPECT_EQ(corners, expected["corner_vertices"]);
  // It opens again as a polyhedron; the tags are for others.
  const Outcome again = run("info --json '" + path("out.obj") + "'");
  EXPECT_EQ(again.object()["vertices"], expected["vertices"]);
  EXPECT_EQ(run("export --control " + golden("cube.obj") + " '" + path("no.obj") + "'").exit_code, 1);
  EXPECT_EQ(run("export --control " + sections("fig5") + " '" + path("no.stl") + "'").exit_code, 2);
}

}  // namespace
}  // namespace hariko::test

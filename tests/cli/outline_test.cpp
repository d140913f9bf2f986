// Outlines on the command line: their JSON layout opens wherever a file is expected.

#include <cmath>

#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class OutlineFiles : public ProgramTest {};

TEST_F(OutlineFiles, EvaluatePrintsTheControlPoints) {
  const Outcome result = succeed("evaluate " + golden("gaussmap/sphere_cap.json"));
  const Json json = result.json();
  const Json input = Json::parse(read_text(golden("gaussmap/sphere_cap.json")));
  const std::size_t given = input["loops"][0]["points"].size();
  EXPECT_EQ(json["method"], "curvature");
  EXPECT_EQ(json["loops"], Json::array({given}));
  const std::size_t count = json["points"].size();
  EXPECT_EQ(count, given + json["inserted"].get<std::size_t>());
  for (const char* list : {"normals", "h", "K", "boundary"}) EXPECT_EQ(json[list].size(), count) << list;
  for (std::size_t i = 0; i < count; ++i) {
    double square = 0, height = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double p = json["points"][i][k], n = json["normals"][i][k];
      square += p * p;
      height += p * n;
    }
    EXPECT_NEAR(std::sqrt(square), 2, 1e-5);  // the cap of a sphere of radius 2
    EXPECT_NEAR(height, json["h"][i].get<double>(), 1e-9);
    EXPECT_NEAR(json["K"][i].get<double>(), 0.25, 0.02);
    EXPECT_EQ(json["boundary"][i].get<bool>(), i < given);
    if (i < given) {
      EXPECT_EQ(json["points"][i], input["loops"][0]["points"][i]);
    }
  }
  // A disc: vertices - edges + faces = 1, where 3 faces = 2 edges - border edges.
  const std::size_t faces = json["triangles"].size();
  EXPECT_EQ(2 * count, faces + given + 2);
  EXPECT_TRUE(json["messages"].empty());
}

TEST_F(OutlineFiles, InfoCountsThem) {
  const Json object = run("info --json " + golden("gaussmap/sphere_band.json")).object();
  EXPECT_EQ(object["kind"], "outline");
  EXPECT_EQ(object["outline"]["loops"], 2);
  EXPECT_EQ(object["boundary_loops"], 2);
  const std::size_t points = object["outline"]["points"], inserted = object["outline"]["inserted"];
  EXPECT_EQ(object["vertices"], points + inserted);
  EXPECT_EQ(object["patches"], 3 * object["faces"].get<std::size_t>());
  EXPECT_GT(object["outline"]["gap"], 0);
  // The unit sphere's zone between 40 and 120 degrees.
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(object["area"].get<double>(), 2 * pi * (std::cos(2 * pi / 9) + 0.5), 0.01);
}

TEST_F(OutlineFiles, WhatIsWrongIsSaidWithThePoint) {
  const Outcome bad = run("evaluate " + golden("gaussmap/bad_normal.json"));
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_NE(bad.error.find("E_COARSE (vertex"), std::string::npos) << bad.error;
  const Outcome described = run("info --json " + golden("gaussmap/bad_inward.json"));
  EXPECT_EQ(described.exit_code, 1);
  EXPECT_EQ(described.object()["messages"][0]["code"], "E_NOT_CONVEX");
  EXPECT_TRUE(described.object()["area"].is_null());
}

TEST_F(OutlineFiles, ExportAndRender) {
  succeed("export --density 2 " + golden("gaussmap/saddle.json") + " " + path("saddle.obj"));
  EXPECT_NE(read_text(path("saddle.obj")).find("\nf "), std::string::npos);
  succeed("render --size 64x48 " + golden("gaussmap/three_holes.json") + " " + path("holes.png"));
}

TEST_F(OutlineFiles, OptionsTakeThePlaceOfTheSettings) {
  const std::string file = golden("gaussmap/ellipsoid_cap.json");
  const Json usual = run("evaluate " + file).json();
  const Json other = run("evaluate --method umbilic --spacing 1.2 " + file).json();
  EXPECT_EQ(usual["method"], "curvature");
  EXPECT_EQ(other["method"], "umbilic");
  EXPECT_EQ(other["radius"], 1.2);
  EXPECT_LT(other["inserted"], usual["inserted"]);
  EXPECT_GT(other["gap"], usual["gap"]);
  const double wanted = (other["gap"].get<double>() + usual["gap"].get<double>()) / 2;
  const Json closer = run("evaluate --spacing 1.2 --gap " + std::to_string(wanted) + " " + file).json();
  EXPECT_LE(closer["gap"].get<double>(), wanted);
  const Json few = run("info --json --count 5 " + file).object();
  EXPECT_EQ(few["outline"]["inserted"], 5);
  EXPECT_EQ(few["messages"][0]["code"], "W_POINT_LIMIT");
  const Json saddle = run("evaluate --method position " + golden("gaussmap/saddle.json")).json();
  EXPECT_EQ(saddle["method"], "position");
  // Patches: a curvature-continuous surface, by its own measure.
  const Json fair = run("info --json " + file).object(),
             smooth = run("info --json --mode g2 " + file).object();
  EXPECT_LT(smooth["rms_curvature_jump"].get<double>(), 0.1 * fair["rms_curvature_jump"].get<double>());
}

TEST_F(OutlineFiles, AModeThatIsGoneIsReplacedWithAWarning) {
  const std::string file = golden("gaussmap/ellipsoid_cap.json");
  const Outcome replaced = succeed("evaluate --method minkowski " + file);
  Json json = replaced.json();
  EXPECT_EQ(json["method"], "umbilic");
  ASSERT_FALSE(json["messages"].empty());
  EXPECT_EQ(json["messages"][0]["code"], "W_OUTLINE_METHOD");
  json["messages"].erase(json["messages"].begin());
  EXPECT_EQ(json, run("evaluate --method umbilic " + file).json()) << "once, and nothing else differs";
  const std::string old = test::source_folder() + "/tests/document/fixtures/v9_outline.hariko";
  for (const std::string& arguments : {"--method minkowski " + file, old}) {
    const Json object = run("info --json " + arguments).object();
    EXPECT_EQ(object["outline"]["method"], "umbilic");
    ASSERT_FALSE(object["messages"].empty());
    EXPECT_EQ(object["messages"][0]["code"], "W_OUTLINE_METHOD");
  }
  const Json chosen = run("info --json --method curvature " + old).object();
  EXPECT_EQ(chosen["outline"]["method"], "curvature");
  for (const Json& message : chosen["messages"]) EXPECT_NE(message["code"], "W_OUTLINE_METHOD");
  EXPECT_EQ(run("info --help").out.find("minkowski"), std::string::npos);
}

TEST_F(OutlineFiles, FramesAreMetricUnlessToldOtherwise) {
  const std::string file = golden("gaussmap/ellipsoid_cap.json");
  for (const char* mode : {"fair", "g2"}) {
    SCOPED_TRACE(mode);
    const auto jump = [&](const std::string& options) {
      return run("info --json --mode " + std::string(mode) + options + " " + file)
          .object()["rms_curvature_jump"]
          .get<double>();
    };
    EXPECT_EQ(jump(""), jump(" --frames metric"));
    EXPECT_NE(jump(""), jump(" --frames equal"));
  }
}

TEST_F(OutlineFiles, WrongOptionsAreRefused) {
  const std::string file = golden("gaussmap/ellipsoid_cap.json");
  for (const char* options :
       {"--method fair", "--spacing 0", "--count -1", "--count 20001", "--gap 0", "--sign 1"})
    EXPECT_EQ(run("evaluate " + std::string(options) + " " + file).exit_code, 2) << options;
}

}  // namespace
}  // namespace hariko::test

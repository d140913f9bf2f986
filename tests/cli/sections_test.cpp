// Section curves by `hariko sections`.

#include <map>
#include <set>

#include "core/cad/kernel/cad_file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

class Sections : public ProgramTest {};

TEST_F(Sections, PlanesAreSpreadOverTheModelAndWrittenInLayers) {
  const Outcome result = run("sections " + golden("fig2.obj") + " " + path("a.svg") + " --planes 4 --json");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  const Json curves = result.json()["curves"];
  ASSERT_GE(curves.size(), 4U) << "each plane meets the model";
  std::set<int> planes;
  for (const Json& curve : curves) {
    planes.insert(curve["plane"].get<int>());
    EXPECT_GT(curve["length"].get<double>(), 0);
    EXPECT_GE(curve["greatest_curvature"].get<double>(), 0);
  }
  EXPECT_EQ(planes, (std::set<int>{1, 2, 3, 4}));
  const std::string svg = read_text(path("a.svg"));
  for (const char* layer : {"section-1", "section-4", "comb-1", "comb-4"})
    EXPECT_NE(svg.find("id=\"" + std::string(layer) + "\""), std::string::npos) << layer;
}

/// Number of curves in each plane, the first one first; all of them are closed.
std::vector<int> closed_curves(const Json& curves, int planes) {
  std::vector<int> out(std::size_t(planes), 0);
  for (const Json& curve : curves) {
    EXPECT_TRUE(curve["closed"].get<bool>()) << curve.dump();
    EXPECT_GT(curve["length"].get<double>(), 0.1) << curve.dump();
    ++out[curve["plane"].get<std::size_t>() - 1];
  }
  return out;
}

TEST_F(Sections, PlanesOfSymmetryCutWholeCurvesAndNoSpecks) {
  // Seven planes across the long side; the fourth runs along seams, and through the holes.
  const std::map<std::string, std::vector<int>> models{
      {"cube", {1, 1, 1, 1, 1, 1, 1}}, {"torus", {1, 1, 2, 2, 2, 1, 1}}, {"genus3", {1, 2, 1, 2, 1, 2, 1}}};
  for (const auto& [model, counts] : models) {
    const std::string file = source_folder() + "/assets/samples/" + model + ".hariko";
    const Outcome result = succeed("sections " + file + " " + path("a.dxf") + " --json");
    EXPECT_EQ(closed_curves(result.json()["curves"], 7), counts) << model;
  }
  // The smooth surface of a cube of 50 mm, cut in the middle.
  write_text(path("box.obj"),
             "v 0 0 0\nv 50 0 0\nv 50 50 0\nv 0 50 0\nv 0 0 50\nv 50 0 50\nv 50 50 50\nv 0 50 50\n"
             "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const char* across : {"x", "y", "z", "1,1,0"}) {
    const Outcome result =
        run("sections " + path("box.obj") + " " + path("a.svg") + " --planes 1 --json --across " + across);
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const Json curves = result.json()["curves"];
    EXPECT_EQ(closed_curves(curves, 1), std::vector<int>{1}) << across;
    if (std::string(across).size() == 1) EXPECT_NEAR(curves.at(0)["length"].get<double>(), 269.46, 0.01);
  }
}

TEST_F(Sections, BallsAndRingsOfCadProgramsAreCutInClosedCurves) {
  if (why_no_cad_files()) GTEST_SKIP() << "built without OpenCASCADE";
  // A ball of radius 5, a ring of radii 10 and 3, both bounded by one point; their facets crowd round it.
  const std::string cases = source_folder() + "/tests/cases/";
  const Outcome ball =
      run("sections " + cases + "step_sphere_of_vertex_loop.step " + path("a.dxf") + " --planes 1 --json");
  ASSERT_EQ(ball.exit_code, 0) << ball.error;
  const Json circle = ball.json()["curves"];
  EXPECT_EQ(closed_curves(circle, 1), std::vector<int>{1});
  EXPECT_NEAR(circle.at(0)["length"].get<double>(), 31.416, 0.05);
  const Outcome ring =
      succeed("sections " + cases + "step_torus_of_vertex_loop.step " + path("a.dxf") + " --json");
  const Json curves = ring.json()["curves"];
  EXPECT_EQ(closed_curves(curves, 7), (std::vector<int>{1, 1, 2, 2, 2, 1, 1}));
  // The planes lie symmetrically: the second and the last but one cut the same curve.
  EXPECT_NEAR(curves.at(1)["length"].get<double>(), curves.at(8)["length"].get<double>(), 1e-3);
}

TEST_F(Sections, DxfWithoutCombsHasThePlacesOfThePlanes) {
  // One flat triangle.
  write_text(path("flat.obj"), "v 0 0 0\nv 10 0 0\nv 0 0 10\nf 1 2 3\n");
  const Outcome result = succeed("sections " + path("flat.obj") + " " + path("a.dxf") +
                                 " --across z --planes 2 --first 2 --step 3 --combs off --json");
  const Json curves = result.json()["curves"];
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_NEAR(curves[0]["length"].get<double>(), 8, 0.2);
  EXPECT_NEAR(curves[1]["offset"].get<double>(), 5, 1e-12);
  EXPECT_FALSE(curves[0]["closed"].get<bool>());
  const std::string dxf = read_text(path("a.dxf"));
  EXPECT_NE(dxf.find("8\nSECTION_2\n"), std::string::npos);
  EXPECT_EQ(dxf.find("0\nLINE\n8\nCOMB"), std::string::npos);
}

TEST_F(Sections, WhatCannotBeIsSaid) {
  const std::string file = golden("fig2.obj");
  EXPECT_EQ(run("sections " + file + " " + path("a.png")).exit_code, 2);
  EXPECT_EQ(run("sections " + file + " " + path("a.svg") + " --across w").exit_code, 2);
  EXPECT_EQ(run("sections " + file + " " + path("a.svg") + " --across 0,0,0").exit_code, 2);
  EXPECT_EQ(run("sections " + file + " " + path("a.svg") + " --planes 0").exit_code, 2);
  EXPECT_EQ(run("sections " + file + " " + path("a.svg") + " --step -1").exit_code, 2);
  const Outcome beyond = run("sections " + file + " " + path("a.svg") + " --first 1e6 --step 1");
  EXPECT_EQ(beyond.exit_code, 1);
  EXPECT_NE(beyond.error.find("E_SECTIONS_EMPTY"), std::string::npos) << beyond.error;
  EXPECT_FALSE(std::filesystem::exists(path("a.svg")));
}

}  // namespace
}  // namespace hariko::test

// Section curves by `hariko sections`.

#include <set>

#include "tests/cli/program.hpp"

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

TEST_F(Sections, DxfWithoutCombsHasThePlacesOfThePlanes) {
  // One flat triangle.
  write_text(path("flat.obj"), "v 0 0 0\nv 10 0 0\nv 0 0 10\nf 1 2 3\n");
  const Outcome result = run("sections " + path("flat.obj") + " " + path("a.dxf") +
                             " --across z --planes 2 --first 2 --step 3 --combs off --json");
  ASSERT_EQ(result.exit_code, 0) << result.error;
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

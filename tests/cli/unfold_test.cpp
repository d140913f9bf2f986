// hariko unfold: files, sizes, refusals.

#include <algorithm>

#include "core/document/edits/edit_objects.hpp"
#include "core/document/file.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/places.hpp"

namespace hariko::test {
namespace {

class Unfold : public ProgramTest {
 protected:
  std::string facets(const std::string& name) const { return golden("unfolding/" + name + ".obj"); }
};

TEST_F(Unfold, WritesEveryFormatAndSaysWhatItMade) {
  const std::string outs =
      path("w.json") + " " + path("w.svg") + " " + path("w.dxf") + " " + path("w.pdf") + " " + path("w.png");
  const Outcome result =
      succeed("unfold " + facets("wave_opt") + " " + outs + " --width 250 --steps 20000 --json");
  const Json summary = result.json();
  EXPECT_EQ(summary["facets"], 241);
  EXPECT_EQ(summary["overlaps"], 0);
  EXPECT_EQ(summary["joints"], summary["tabs"].get<int>() + summary["strips"].get<int>());
  EXPECT_GE(summary["paper_use"].get<double>(), 0.38);
  EXPECT_NEAR(summary["scale"].get<double>(), 250 / 3.0, 1e-9);
  const Json layout = Json::parse(read_text(path("w.json")));
  EXPECT_EQ(layout["faces"].size(), 241U);
  EXPECT_EQ(layout["folds"].size(), 241U - summary["pieces"].get<std::size_t>());
  EXPECT_EQ(read_text(path("w.png")).rfind("\x89PNG", 0), 0U);
  EXPECT_EQ(read_text(path("w.svg")).rfind("<?xml", 0), 0U);
  EXPECT_EQ(read_text(path("w.pdf")).rfind("%PDF-1.4", 0), 0U);
  EXPECT_EQ(read_text(path("w.dxf")).rfind("0\nSECTION\n", 0), 0U);
}

TEST_F(Unfold, WrongSizesAndMissingFoldersAreSaidShortly) {
  const std::string command = "unfold " + golden("cube.obj") + " ";
  for (const char* height : {"0", "-3", "inf", "high"}) {
    const Outcome result = run(command + path("a.pdf") + " --height " + height);
    EXPECT_EQ(result.exit_code, 2) << height;
    EXPECT_NE(result.error.find(std::string("--height: should be a number above 0, but is ") + height),
              std::string::npos)
        << result.error;
  }
  const Outcome missing = run(command + path("none/a.pdf"));
  EXPECT_NE(missing.error.find("E_FILE_WRITE"), std::string::npos) << missing.error;
  EXPECT_NE(missing.error.find("its folder does not exist"), std::string::npos) << missing.error;
}

TEST_F(Unfold, SamplesAndPolyhedraBecomePaper) {
  const std::string sample = test::source_folder() + "/assets/samples/fig2.hariko";
  const Outcome result = run("unfold " + sample + " " + path("v.json") + " --height 120 --steps 1000 --json");
  ASSERT_EQ(result.exit_code, 0) << result.error;
  EXPECT_EQ(result.json()["overlaps"], 0);
  EXPECT_GT(result.json()["facets"], 50);
}

TEST_F(Unfold, TheSameInputGivesTheSameFiles) {
  const auto of = [&](const std::string& out) {
    EXPECT_EQ(run("unfold " + facets("dome_opt") + " " + path(out) + " --width 200 --steps 5000").exit_code,
              0);
    return read_text(path(out));
  };
  EXPECT_EQ(of("a.svg"), of("b.svg"));
}

TEST_F(Unfold, FaultsOfMeshesAreNamed) {
  write_text(path("bad.obj"),
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 2 0 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\nf 1 2 6\n");
  const Outcome result = run("unfold " + path("bad.obj") + " " + path("o.svg"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.error.find("non-manifold edge: 4 facets share edge (0,1)"), std::string::npos)
      << result.error;
  EXPECT_NE(result.error.find("degenerate facet 3 has zero area"), std::string::npos) << result.error;
  EXPECT_FALSE(std::filesystem::exists(path("o.svg")));
}

TEST_F(Unfold, KindsFromElsewhereAreLeftOutWithACount) {
  PolygonMesh triangle;
  triangle.positions = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}};
  triangle.add_face({0, 1, 2});
  Document document = document_from_mesh(triangle, "Sheet").value();
  for (const char* name : {"one", "two"})
    document =
        add_object(document, name, UnknownSource{"dream", std::string("{\"kind\":\"dream\"}")})->document;
  ASSERT_TRUE(save_document(document, path("a.hariko")).ok());
  const Outcome result = succeed("unfold " + path("a.hariko") + " " + path("o.svg"));
  EXPECT_NE(result.error.find("W_NOT_WRITTEN: Objects left out: 2 (\"one\", \"two\")"), std::string::npos)
      << result.error;
}

TEST_F(Unfold, FaultsOfAKindAreOneLine) {
  std::string text;
  const int count = 500;
  for (int k = 0; k < count + 2; ++k) text += "v " + std::to_string(k) + " " + std::to_string(k % 2) + " 0\n";
  for (int k = 1; k <= count; ++k)
    text += "f " + std::to_string(k) + " " + std::to_string(k + 1) + " " + std::to_string(k + 2) + "\n";
  write_text(path("strip.obj"), text);
  const Outcome refused = run("unfold " + path("strip.obj") + " " + path("o.svg"));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(std::count(refused.error.begin(), refused.error.end(), '\n'), 2) << "what helps, and the fault";
  EXPECT_NE(refused.error.find("(499 like this: edge 1-2, edge 2-3"), std::string::npos) << refused.error;
}

TEST_F(Unfold, PagesAreNotLostOnTheStandardOutput) {
  const std::string cube = "unfold " + golden("cube.obj") + " - ";
  const Outcome large = run(cube + "--to svg --height 400");
  EXPECT_EQ(large.exit_code, 1) << "SVG has one page a file";
  EXPECT_EQ(large.out, "");
  EXPECT_NE(large.error.find("E_OUTPUT"), std::string::npos) << large.error;
  const Outcome whole = succeed(cube + "--to pdf --height 400");
  EXPECT_TRUE(whole.out.starts_with("%PDF"));
  const Outcome small = succeed(cube + "--to svg --height 50");
  EXPECT_TRUE(small.out.starts_with("<?xml"));
}

TEST_F(Unfold, FacesOfAnyNumberOfSidesStayWhole) {
  const Outcome cube = succeed("unfold " + golden("cube.obj") + " " + path("c.svg") + " " + path("c.json") +
                               " --height 50 --json");
  EXPECT_EQ(cube.json()["facets"], 6);
  EXPECT_EQ(cube.json()["pieces"], 1);
  EXPECT_EQ(cube.json()["joints"], 7);
  const Json layout = Json::parse(read_text(path("c.json")));
  ASSERT_EQ(layout["faces"].size(), 6U);
  for (const Json& face : layout["faces"]) EXPECT_EQ(face["xy"].size(), 4U);
  EXPECT_EQ(layout["folds"].size(), 5U);

  const Outcome twelve =
      succeed("unfold " + facets("dodecahedron_pentagons") + " " + path("d.svg") + " --height 100 --json");
  EXPECT_EQ(twelve.json()["facets"], 12);
  EXPECT_LE(twelve.json()["pieces"], 2);
  EXPECT_EQ(twelve.json()["overlaps"], 0);
  // No line across a pentagon: 30 edges, each a fold or a joint.
  EXPECT_EQ(twelve.json()["joints"].get<int>() + 12 - twelve.json()["pieces"].get<int>(), 30);
}

TEST_F(Unfold, TrianglesWithCornersOfTheirOwnHangTogether) {
  const Outcome cube = run("unfold " + facets("cube_unwelded_triangles") + " " + path("c.pdf") + " --json");
  ASSERT_EQ(cube.exit_code, 0) << cube.error;
  EXPECT_EQ(cube.json()["components"], 1);
  EXPECT_EQ(cube.json()["pieces"], 1);
  EXPECT_EQ(cube.json()["joints"], 7);
  EXPECT_EQ(cube.json()["overlaps"], 0);
}

TEST_F(Unfold, FacetsLargerThanThePageAreCutOrTheModelFits) {
  const Outcome cut = succeed("unfold " + golden("cube.obj") + " " + path("c.svg") + " --height 400 --json");
  EXPECT_NE(cut.error.find("6 facets are larger than the page"), std::string::npos) << cut.error;
  EXPECT_GT(cut.json()["facets"], 6);
  EXPECT_EQ(cut.json()["overlaps"], 0);
  EXPECT_NEAR(cut.json()["scale"].get<double>(), 200, 1e-9);
  // One file a page.
  const int pages = cut.json()["pages"];
  EXPECT_TRUE(std::filesystem::exists(path("c.svg")));
  for (int page = 2; page <= pages; ++page)
    EXPECT_TRUE(std::filesystem::exists(path("c-" + std::to_string(page) + ".svg"))) << page;
  EXPECT_FALSE(std::filesystem::exists(path("c-" + std::to_string(pages + 1) + ".svg")));

  const Outcome fit = succeed("unfold " + golden("cube.obj") + " " + path("f.svg") + " --fit --json");
  EXPECT_EQ(fit.json()["facets"], 6);
  // A4 less margins and tabs is 180 mm wide.
  EXPECT_NEAR(2 * fit.json()["scale"].get<double>(), 180, 2);
  EXPECT_EQ(run("unfold " + golden("cube.obj") + " " + path("f.svg") + " --fit --height 3").exit_code, 2);
}

TEST_F(Unfold, SizesThatAreHardlyMeantAreTold) {
  const Outcome small = succeed("unfold " + golden("cube.obj") + " " + path("c.svg") + " --height 9");
  EXPECT_NE(small.error.find("9.0 mm small"), std::string::npos) << small.error;
  const Outcome large =
      succeed("unfold " + golden("cube.obj") + " " + path("c.svg") + " --height 2100 --page 3000x3000");
  EXPECT_NE(large.error.find("2.10 m large"), std::string::npos) << large.error;
  const Outcome usual = run("unfold " + golden("cube.obj") + " " + path("c.svg") + " --height 60");
  EXPECT_EQ(usual.error, "");
}

TEST_F(Unfold, NoTabIsLowerThanTheLeastHeight) {
  const std::string wave =
      "unfold " + facets("wave_opt") + " " + path("w.json") + " --steps 0 --width 120 --json";
  const Outcome few = run(wave + " --least-tab 4"), some = run(wave), all = run(wave + " --least-tab 0");
  ASSERT_EQ(few.exit_code, 0) << few.error;
  EXPECT_LT(few.json()["tabs"], some.json()["tabs"]);
  EXPECT_LT(some.json()["tabs"], all.json()["tabs"]);
  for (const Outcome* outcome : {&few, &some, &all})
    EXPECT_EQ(outcome->json()["joints"],
              outcome->json()["tabs"].get<int>() + outcome->json()["strips"].get<int>());
}

TEST_F(Unfold, TooManyPagesAndWrongUsageAreRefused) {
  const Outcome large =
      run("unfold " + facets("wave_opt") + " " + path("o.svg") + " --width 90000 --steps 0");
  EXPECT_EQ(large.exit_code, 1);
  EXPECT_NE(large.error.find("more than 2000 pages"), std::string::npos) << large.error;
  for (const std::string wrong : {"o.bmp", "o.svg --page B9", "o.svg --distance 0", "o.svg --goal none",
                                  "o.svg --height 10 --width 10", "o.svg --height -3"})
    EXPECT_EQ(run("unfold " + facets("wave_opt") + " " + wrong).exit_code, 2) << wrong;
}

/// A cube of 20 mm: every face has corners of its own, moved by up to `off`.
std::string loose_cube(double off) {
  const double c[8][3] = {{0, 0, 0},  {20, 0, 0},  {20, 20, 0},  {0, 20, 0},
                          {0, 0, 20}, {20, 0, 20}, {20, 20, 20}, {0, 20, 20}};
  const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                           {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  std::string vertices, rows;
  int number = 0;
  for (const auto& face : faces) {
    rows += "f";
    for (const int v : face) {
      vertices += "v";
      for (const double x : c[v]) vertices += " " + std::to_string(x + off * (number % 3));
      vertices += "\n";
      rows += " " + std::to_string(++number);
    }
    rows += "\n";
  }
  return vertices + rows;
}

TEST_F(Unfold, CornersThatAreNearlyEqualAreJoinedWhereThatIsAsked) {
  write_text(path("near.obj"), loose_cube(1e-3));
  const std::string unfold = "unfold " + path("near.obj") + " " + path("o.svg") + " --json";
  const Outcome loose = succeed(unfold);
  EXPECT_EQ(loose.json()["components"], 6);
  EXPECT_NE(loose.error.find("W_NEAR_CORNERS"), std::string::npos) << loose.error;
  EXPECT_NE(loose.error.find("(--weld 0.00"), std::string::npos) << loose.error;
  const Outcome joined = succeed(unfold + " --weld 0.01");
  EXPECT_EQ(joined.json()["components"], 1);
  EXPECT_EQ(joined.json()["pieces"], 1);
  EXPECT_EQ(joined.json()["joints"], 7);
  EXPECT_NE(joined.error.find("W_CORNERS_JOINED"), std::string::npos) << joined.error;
}

TEST_F(Unfold, MeshesThatAreNotManifoldAreRepairedWhereThatIsAsked) {
  // The last face is turned over.
  write_text(
      path("turned.obj"),
      "v 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nv 10 10 20\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 1 4 5\n");
  const std::string unfold = "unfold " + path("turned.obj") + " " + path("o.svg") + " --json";
  const Outcome refused = run(unfold);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.error.find("W_CAN_BE_OPENED"), std::string::npos) << refused.error;
  EXPECT_NE(refused.error.find("--repair"), std::string::npos) << refused.error;
  EXPECT_EQ(run(unfold + " --reference").exit_code, 1);
  const Outcome repaired = succeed(unfold + " --repair");
  EXPECT_NE(repaired.error.find("faces turned: 1"), std::string::npos) << repaired.error;
  EXPECT_EQ(repaired.json()["facets"], 5);
  EXPECT_EQ(repaired.json()["pieces"], 1);
}

TEST_F(Unfold, BezierPatchesBesidePolygonsAreUnfoldedToo) {
  write_text(
      path("both.obj"),
      "o plate\nv 0 0 0\nv 20 0 0\nv 20 20 0\nv 0 20 0\nf 1 2 3 4\no flag\nv 30 0 0\nv 50 0 0\nv 30 20 0\n"
      "v 50 20 0\ncstype bezier\ndeg 1 1\nsurf 0 1 0 1 5 6 7 8\nparm u 0 1\nparm v 0 1\nend\n");
  const Outcome result = succeed("unfold " + path("both.obj") + " " + path("o.svg") + " --json");
  EXPECT_EQ(result.json()["components"], 2);
  EXPECT_EQ(result.json()["pieces"], 2);
}

}  // namespace
}  // namespace hariko::test

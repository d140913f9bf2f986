// hariko unfold: files, sizes, refusals.

#include <cmath>

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
      run("unfold " + facets("wave_opt") + " " + outs + " --width 250 --steps 20000 --json");
  ASSERT_EQ(result.exit_code, 0) << result.error;
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
  const Outcome quads = run("unfold " + golden("cube.obj") + " " + path("o.svg"));
  EXPECT_EQ(quads.exit_code, 1);
  EXPECT_NE(quads.error.find("facet 0 is not triangular"), std::string::npos) << quads.error;
}

TEST_F(Unfold, TooLargePiecesAndWrongUsageAreRefused) {
  const Outcome large = run("unfold " + facets("wave_opt") + " " + path("o.svg") + " --width 9000 --steps 0");
  EXPECT_EQ(large.exit_code, 1);
  EXPECT_NE(large.error.find("does not fit on the page at this scale"), std::string::npos) << large.error;
  for (const std::string wrong : {"o.bmp", "o.svg --page B9", "o.svg --distance 0", "o.svg --goal none",
                                  "o.svg --height 10 --width 10", "o.svg --height -3"})
    EXPECT_EQ(run("unfold " + facets("wave_opt") + " " + wrong).exit_code, 2) << wrong;
}

}  // namespace
}  // namespace hariko::test

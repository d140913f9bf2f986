// `hariko evaluate` against the numbers of an independent implementation.

#include <cmath>
#include <sstream>

#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class Evaluate : public ProgramTest {};

/// Same structure, numbers equal to 1e-9 (relative above 1).
void expect_same(const Json& actual, const Json& expected, const std::string& where) {
  if (::testing::Test::HasFailure()) return;  // one message is enough
  if (expected.is_object()) {
    ASSERT_TRUE(actual.is_object()) << where;
    for (const auto& [key, value] : expected.items()) {
      ASSERT_TRUE(actual.contains(key)) << where << "/" << key;
      expect_same(actual[key], value, where + "/" + key);
    }
    ASSERT_EQ(actual.size(), expected.size()) << where;
  } else if (expected.is_array()) {
    ASSERT_TRUE(actual.is_array()) << where;
    ASSERT_EQ(actual.size(), expected.size()) << where;
    for (std::size_t i = 0; i < expected.size(); ++i)
      expect_same(actual[i], expected[i], where + "/" + std::to_string(i));
  } else if (expected.is_number()) {
    ASSERT_TRUE(actual.is_number()) << where;
    const double value = expected;
    ASSERT_NEAR(actual.get<double>(), value, 1e-9 * std::max(1.0, std::abs(value))) << where;
  } else {
    ASSERT_EQ(actual, expected) << where;
  }
}

TEST_F(Evaluate, GoldenFiles) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(golden(""))) {
    const std::string name = entry.path().filename();
    if (entry.path().extension() != ".json" || name.find(".tension.") != std::string::npos) continue;
    SCOPED_TRACE(name);
    const std::string stem = entry.path().stem();
    const std::string model = stem.substr(0, stem.rfind('_')), mode = stem.substr(stem.rfind('_') + 1);
    const bool tension = std::filesystem::exists(golden(model + ".tension.json"));
    const std::string mesh = model == "cube_crease" ? "cube" : model.starts_with("fig5") ? "fig2" : model;
    const Outcome result = run("evaluate " + golden(mesh + ".obj") + " --frames equal --mode " + mode +
                               (tension ? " --tension " + golden(model + ".tension.json") : std::string()));
    ASSERT_EQ(result.exit_code, 0) << result.error;
    const Json actual = result.json();
    ASSERT_FALSE(actual.is_discarded());
    expect_same(actual, Json::parse(read_text(entry.path())), "");
    EXPECT_LE(actual["metrics"]["g1"].get<double>(), 1e-12);
    EXPECT_LE(actual["metrics"]["gap"].get<double>(), 1e-14);
    ++files;
  }
  EXPECT_EQ(files, 24);
}

TEST_F(Evaluate, FairIsTheDefaultMode) {
  EXPECT_EQ(run("evaluate " + golden("cube.obj")).json()["mode"], "fair");
}

TEST_F(Evaluate, ImportsHaveFramesByMeasure) {
  const auto bending = [&](const std::string& options) {
    return run("evaluate " + golden("prism6.obj") + options).json()["metrics"]["bend"].get<double>();
  };
  EXPECT_NEAR(bending(""), 28.2535, 1e-3);
  EXPECT_EQ(bending(""), bending(" --frames metric"));
  EXPECT_NEAR(bending(" --frames equal"), 36.9845, 1e-3);
}

TEST_F(Evaluate, ImportsHaveTheirConcaveFacesCut) {
  const Json json = run("evaluate " + golden("concave.obj") + " --frames equal").json();
  EXPECT_NEAR(json["metrics"]["bend"].get<double>(), 90.97, 0.1);
}

TEST_F(Evaluate, ImportsHaveTheirFlatTrianglesMerged) {
  // A cube of twelve triangles.
  std::string text;
  for (const char* z : {"-1", "1"})
    for (const char* xy : {"-1 -1", "1 -1", "1 1", "-1 1"}) text += "v " + std::string(xy) + " " + z + "\n";
  for (const char* face : {"1 4 3 2", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"}) {
    std::istringstream corners(face);
    std::string a, b, c, d;
    corners >> a >> b >> c >> d;
    text += "f " + a + " " + b + " " + c + "\nf " + a + " " + c + " " + d + "\n";
  }
  write_text(path("cube.obj"), text);
  const auto bending = [&](const std::string& options) {
    return run("evaluate " + path("cube.obj") + options).json()["metrics"]["bend"].get<double>();
  };
  EXPECT_NEAR(bending(""), 25.2341, 1e-3) << "as of six squares";
  EXPECT_EQ(bending(""), bending(" --merge-coplanar on"));
  EXPECT_GT(bending(" --merge-coplanar off"), 26);
}

TEST_F(Evaluate, TensionFilesWithMistakesAreRefused) {
  for (const std::string text : {"",
                                 "[",
                                 "[]",
                                 "{\"beta\": 1}",
                                 "{\"beta\": {\"0\": 1}}",
                                 "{\"beta\": {\"0-6\": 1}}",
                                 "{\"beta\": {\"0-0\": 1}}",
                                 "{\"beta\": {\"0-1\": \"x\"}}",
                                 "{\"beta\": {\"0-99\": 1}}",
                                 "{\"beta\": {\"a-b\": 1}}",
                                 "{\"alpha\": {\"8\": 1}}",
                                 "{\"alpha\": {\"-1\": 1}}",
                                 "{\"alpha\": {\"0\": null}}",
                                 "{\"crease\": {}}",
                                 "{\"crease\": [[0]]}",
                                 "{\"crease\": [[0, 6]]}",
                                 "{\"crease\": [[0, -1]]}",
                                 "{\"corner\": [8]}",
                                 "{\"corner\": [0.5]}",
                                 "{\"gamma\": {}}",
                                 "{\"alpha\": {\"0\": 1e999}}"}) {
    write_text(path("t.json"), text);
    const Outcome result = run("evaluate " + golden("cube.obj") + " --tension " + path("t.json"));
    EXPECT_EQ(result.exit_code, 1) << text;
    EXPECT_NE(result.error.find("E_TENSION_FILE"), std::string::npos) << text << "\n" << result.error;
    EXPECT_TRUE(result.out.empty());
  }
  write_text(path("t.json"), "{\"beta\": {\"1-0\": -1}}");
  const Outcome negative = run("evaluate " + golden("cube.obj") + " --tension " + path("t.json"));
  EXPECT_EQ(negative.exit_code, 1);
  EXPECT_NE(negative.error.find("E_TENSION_NEGATIVE"), std::string::npos) << negative.error;
}

TEST_F(Evaluate, CornersAndCreasesAreApplied) {
  write_text(path("t.json"), R"({"crease": [[0, 1], [0, 3], [0, 4]], "corner": [0], "beta": {"6-7": 3}})");
  const Outcome sharp = succeed("evaluate " + golden("cube.obj") + " --tension " + path("t.json"));
  const Json plain = run("evaluate " + golden("cube.obj")).json();
  EXPECT_NE(sharp.json()["tangents"]["0-1"], plain["tangents"]["0-1"]);
  EXPECT_NE(sharp.json()["tangents"]["6-7"], plain["tangents"]["6-7"]);
}

TEST_F(Evaluate, ObjectFarAwayHasTheSameShape) {
  // Multiples of 1/16 moved by 2^20 are exact, so the shape relative to the corner is the same to rounding.
  std::string moved;
  std::istringstream lines(read_text(golden("cube.obj")));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) == 0) {
      double x = 0, y = 0, z = 0;
      std::istringstream(line.substr(2)) >> x >> y >> z;
      line = "v " + std::to_string(static_cast<long>(x) + 1048576) + " " +
             std::to_string(static_cast<long>(y)) + " " + std::to_string(static_cast<long>(z));
    }
    moved += line + "\n";
  }
  write_text(path("far.obj"), moved);
  const Outcome far = succeed("evaluate " + path("far.obj"));
  const Json here = run("evaluate " + golden("cube.obj")).json();
  expect_same(far.json()["tangents"], here["tangents"], "tangents");
  EXPECT_NEAR(far.json()["faces"][0]["O"][0].get<double>(), 1048576, 1e-9);
}

/// A quarter of the cylinder x^2 + y^2 = 1 of height 2, its mirror image in y = 0 written the other way
/// round, and a plane beside the first, whose side has another parameter so that it is not joined.
constexpr const char* cylinder_patches =
    R"({"arc": [{"ctrl": [[[1,0,0],[1,0,2]],[[1,1,0],[1,1,2]],[[0,1,0],[0,1,2]]],
        "weights": [[1,1],[0.70710678118654752,0.70710678118654752],[1,1]]},
        {"ctrl": [[[1,0,0],[1,-1,0],[0,-1,0]],[[1,0,2],[1,-1,2],[0,-1,2]]],
        "weights": [[1,0.70710678118654752,1],[1,0.70710678118654752,1]]},
        {"ctrl": [[[0,1,0],[0,1,1],[0,1,1],[0,1,2]],[[0,3,0],[0,3,1],[0,3,1],[0,3,2]]]}]})";

TEST_F(Evaluate, PatchesSayWhereTheyAreAndHowTheyBend) {
  write_text(path("arc.json"), cylinder_patches);
  const Outcome result = succeed("evaluate " + path("arc.json"));
  const Json json = result.json();
  EXPECT_EQ(json["kind"], "bezier");
  EXPECT_EQ(json["seams"], 1);
  EXPECT_EQ(json["smooth_seams"], 1);
  EXPECT_EQ(json["border_sides"], 3 * 4 - 2);
  const Json& at = json["sample_st"];
  ASSERT_EQ(json["patches"].size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const Json& patch = json["patches"][k];
    EXPECT_EQ(patch["degree"], k == 0 ? Json({2, 1}) : k == 1 ? Json({1, 2}) : Json({1, 3}));
    EXPECT_EQ(patch["rational"], k < 2);
    EXPECT_FALSE(patch["flipped"].get<bool>()) << k;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const double s = at[i][0], t = at[i][1];
      const auto number = [&](const Json& list, std::size_t axis) { return list[i][axis].get<double>(); };
      const double x = number(patch["points"], 0), y = number(patch["points"], 1),
                   z = number(patch["points"], 2);
      if (k == 2) {
        EXPECT_NEAR(y, 1 + 2 * s, 1e-13);
        EXPECT_NEAR(patch["gauss"][i].get<double>(), 0, 1e-12);
        EXPECT_NEAR(patch["mean"][i].get<double>(), 0, 1e-12);
        EXPECT_NEAR(std::abs(number(patch["normals"], 0)), 1, 1e-13);
        continue;
      }
      // The exact circle by its rational parameter.
      const double u = k == 0 ? s : t, w = k == 0 ? t : s;
      const double b0 = (1 - u) * (1 - u), b1 = std::sqrt(2.0) * u * (1 - u), b2 = u * u;
      EXPECT_NEAR(x, (b0 + b1) / (b0 + b1 + b2), 1e-13);
      EXPECT_NEAR(y, (k == 0 ? 1 : -1) * (b1 + b2) / (b0 + b1 + b2), 1e-13);
      EXPECT_NEAR(z, 2 * w, 1e-13);
      EXPECT_NEAR(number(patch["normals"], 0) * x + number(patch["normals"], 1) * y, 1, 1e-12);
      EXPECT_NEAR(patch["mean"][i].get<double>(), 0.5, 1e-11);
      EXPECT_NEAR(patch["gauss"][i].get<double>(), 0, 1e-11);
      EXPECT_NEAR(number(patch["principal"], 0), 1, 1e-11);
      EXPECT_NEAR(number(patch["principal"], 1), 0, 1e-11);
    }
  }
  EXPECT_NEAR(json["metrics"]["area"].get<double>(), 3.14159265358979 * 2 + 4, 1e-6);
  EXPECT_LE(json["metrics"]["gap"].get<double>(), 1e-14);
  EXPECT_LE(json["metrics"]["g1"].get<double>(), 1e-9);
}

TEST_F(Evaluate, PatchesThatLookTheOtherWayAreFlippedAndKeepTheirParameters) {
  write_text(path("two.json"), R"({"two": [{"ctrl": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,0]]]},
                                           {"ctrl": [[[1,0,0],[3,0,0]],[[1,1,0],[3,1,0]]]}]})");
  const Json json = run("evaluate " + path("two.json")).json();
  ASSERT_EQ(json["patches"].size(), 2U);
  EXPECT_EQ(json["smooth_seams"], 1);
  for (std::size_t k = 0; k < 2; ++k) {
    const Json& patch = json["patches"][k];
    EXPECT_EQ(patch["flipped"], k == 1);
    for (std::size_t i = 0; i < json["sample_st"].size(); ++i) {
      const double s = json["sample_st"][i][0], t = json["sample_st"][i][1];
      EXPECT_NEAR(patch["points"][i][0].get<double>(), k == 0 ? s : 1 + 2 * t, 1e-15);
      EXPECT_NEAR(patch["points"][i][1].get<double>(), k == 0 ? t : s, 1e-15);
      EXPECT_NEAR(patch["normals"][i][2].get<double>(), 1, 1e-15);
    }
  }
}

TEST_F(Evaluate, CurvatureIsNullWhereASideIsShrunkToAPoint) {
  std::string text = "1\n3 3\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) text += std::to_string(i * j) + " " + std::to_string(j) + " 0\n";
  write_text(path("fan.bpt"), text);
  const Json json = run("evaluate " + path("fan.bpt")).json();
  EXPECT_EQ(json["kind"], "patches");
  const Json& patch = json["patches"][0];
  for (std::size_t i = 0; i < json["sample_st"].size(); ++i) {
    const bool shrunk = json["sample_st"][i][1] == 0.0;
    EXPECT_EQ(patch["gauss"][i].is_null(), shrunk) << i;
    if (!shrunk) {
      EXPECT_NEAR(patch["gauss"][i].get<double>(), 0, 1e-14);
    }
    EXPECT_NEAR(std::abs(patch["normals"][i][2].get<double>()), 1, 1e-12) << i;
  }
}

TEST_F(Evaluate, APatchThatClosesOnItselfStaysClosed) {
  // The last column is the first one but for rounding.
  std::string text = "1\n3 3\n";
  for (int j = 0; j < 4; ++j)
    for (const char* point : {"1 0 ", "2 2 ", "-2 2 ", "1.0000000000000002 0 "})
      text += point + std::to_string(j) + "\n";
  write_text(path("tube.bpt"), text);
  const Json json = run("evaluate " + path("tube.bpt")).json();
  EXPECT_EQ(json["kind"], "bezier");
  EXPECT_EQ(json["seams"], 1);
  EXPECT_EQ(json["border_sides"], 2);
}

}  // namespace
}  // namespace hariko::test

// `hariko evaluate` against the numbers of an independent implementation.

#include <cmath>

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
    const Outcome result = run("evaluate " + golden(mesh + ".obj") + " --mode " + mode +
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
  const Outcome sharp = run("evaluate " + golden("cube.obj") + " --tension " + path("t.json"));
  ASSERT_EQ(sharp.exit_code, 0) << sharp.error;
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
  const Outcome far = run("evaluate " + path("far.obj"));
  ASSERT_EQ(far.exit_code, 0) << far.error;
  const Json here = run("evaluate " + golden("cube.obj")).json();
  expect_same(far.json()["tangents"], here["tangents"], "tangents");
  EXPECT_NEAR(far.json()["faces"][0]["O"][0].get<double>(), 1048576, 1e-9);
}

}  // namespace
}  // namespace hariko::test

// Options of surfaces round solids on the command line.

#include "tests/cli/program.hpp"

namespace hariko::test {
namespace {

class SolidsOptions : public ProgramTest {
 protected:
  Json envelope(const std::string& file, const std::string& options, Json* object = nullptr) {
    const Outcome result = succeed("info '" + file + "' --json " + options);
    const Json found = result.object();
    if (object) *object = found;
    return found.is_object() ? found["envelope"] : Json();
  }
};

TEST_F(SolidsOptions, OnTheFacesSaysWhatSticksOut) {
  const std::string four = golden("envelope/four.json");
  const Json contains = envelope(four, "--rounding 0.1 --ball-radius 1");
  EXPECT_TRUE(contains["enclosed"].get<bool>());
  EXPECT_FALSE(contains.contains("sticks_out"));
  Json object;
  const Json lies = envelope(four, "--rounding 0.1 --ball-radius 1 --on-faces on", &object);
  EXPECT_FALSE(lies["enclosed"].get<bool>());
  EXPECT_GT(lies["sticks_out"].get<double>(), 0.03);
  EXPECT_LT(lies["sticks_out"].get<double>(), 0.3);
  EXPECT_TRUE(object["messages"].empty()) << "it was asked for: " << object["messages"];
  EXPECT_NE(run("info '" + four + "' --on-faces on").out.find("sticks_out"), std::string::npos);
  EXPECT_EQ(envelope(four, "--rounding 0.1 --ball-radius 1 --on-faces off"), contains);
}

TEST_F(SolidsOptions, FinerPatchesAreMore) {
  Json usual, finer;
  envelope(golden("envelope/box.json"), "--rounding 0.1", &usual);
  envelope(golden("envelope/box.json"), "--rounding 0.1 --finer-patches on", &finer);
  EXPECT_GT(finer["patches"].get<double>(), 1.5 * usual["patches"].get<double>());
}

TEST_F(SolidsOptions, BridgesGetTheirBall) {
  const std::string file = path("bridged.json");
  write_text(file, R"({"primitives": [{"type": "box"}, {"type": "box", "position": [1.8, 0, 0]},
    {"type": "capsule", "radius": 0.15, "length": 0.9, "position": [0.9, 0, 0], "rotation": [0, 90, 0],
     "bridge": {"between": [0, 1]}}], "rounding": 0.05, "ball_radius": 2})");
  Json filled, freed;
  envelope(file, "", &filled);
  envelope(file, "--bridge-radius 0.2", &freed);
  EXPECT_LT(freed["volume"].get<double>(), 0.9 * filled["volume"].get<double>());
}

TEST_F(SolidsOptions, ABallsRadiusIsANumberLikeOthers) {
  const std::string four = golden("envelope/four.json");
  Json ten, one;
  envelope(four, "--rounding 0.1 --ball-radius 1.0D1", &ten);
  envelope(four, "--rounding 0.1 --ball-radius 1", &one);
  EXPECT_GT(ten["volume"].get<double>(), 1.2 * one["volume"].get<double>());
  const int smallest = run("info " + golden("envelope/box.json") + " --ball-radius 1e-310").exit_code;
  EXPECT_TRUE(smallest == 0 || smallest == 1) << "no crash: " << smallest;
}

TEST_F(SolidsOptions, OtherWordsAreRefused) {
  for (const std::string options :
       {"--on-faces yes", "--finer-patches 2", "--bridge-radius 0", "--bridge-radius hull"})
    EXPECT_EQ(run("info " + golden("envelope/box.json") + " " + options).exit_code, 2) << options;
}

}  // namespace
}  // namespace hariko::test

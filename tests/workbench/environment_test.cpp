// Environments by hand: shown by a key, chosen in menus and the properties, turned by a drag, lost and found.

#include <set>

#include "app/engines/environment_loader.hpp"
#include "render/image.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko {
namespace {

class EnvironmentByHand : public test::BenchHands {
 protected:
  EnvironmentByHand() : BenchHands(document_from_mesh(test::cube(), "Cube").value(), {1280, 1600}) {
    bench_.wait_for_surfaces();
  }

  /// Waits until the environment is there and shown.
  void settle() {
    for (int i = 0; i < 3; ++i) {
      loader.sync();
      loader.wait();
      loader.publish();
      bench_.frame();
    }
  }
  void run(const std::string& id) {
    const auto outcome = bench_.workbench().commands().run(id);
    EXPECT_TRUE(outcome.ran) << id << ": " << outcome.reason;
    settle();
  }
  bool checked(const char* id) { return bench_.workbench().commands().find(id)->checked(); }
  const Environment& shown() { return bench_.workbench().viewport().scene().scene().environment; }
  std::vector<std::uint8_t> picture() {
    for (int i = 0; i < 4; ++i) bench_.frame();
    return bench_.renderer().read(editor().layout.active()).rgba;
  }
  std::size_t notices(const std::string& part) {
    std::size_t count = 0;
    for (const Notice& notice : editor().notices()) count += notice.text.find(part) != std::string::npos;
    return count;
  }

  test::TemporaryFolder folder;
  EnvironmentLoader loader{editor(), [] {}};
};

TEST_F(EnvironmentByHand, AKeyShowsItAndTakesItAwayWithoutAStep) {
  const auto clay = picture();
  bench_.key("Alt+8");
  settle();
  ASSERT_TRUE(shown().levels);
  EXPECT_TRUE(checked("analyse.environment"));
  EXPECT_FALSE(checked("analyse.shaded"));
  EXPECT_NE(picture(), clay);
  bench_.key("Alt+8");
  settle();
  EXPECT_FALSE(shown().levels);
  EXPECT_TRUE(checked("analyse.shaded"));
  EXPECT_EQ(picture(), clay);
  EXPECT_FALSE(editor().history.dirty());
}

TEST_F(EnvironmentByHand, EachOneOfTheMenuLooksOtherwise) {
  std::set<std::vector<std::uint8_t>> pictures;
  for (const std::string id :
       {"environment.studio", "environment.tubes", "environment.horizon", "environment.overcast"}) {
    run(id);
    EXPECT_TRUE(checked(id.c_str())) << id;
    EXPECT_TRUE(pictures.insert(picture()).second) << id;
  }
  EXPECT_EQ(editor().settings.environment.kind, EnvironmentKind::overcast) << "the next start shows it again";
}

TEST_F(EnvironmentByHand, MapsHideItAndMaterialsEndIt) {
  run("analyse.environment");
  bench_.key("Alt+Z");
  EXPECT_FALSE(checked("analyse.environment"));
  run("analyse.environment");
  EXPECT_FALSE(editor().view.map.map) << "the map that hid it went off";
  EXPECT_TRUE(checked("analyse.environment"));
  run("material.metal");
  EXPECT_FALSE(shown().levels);
  run("analyse.environment");
  run("analyse.shaded");
  EXPECT_FALSE(shown().levels);
}

TEST_F(EnvironmentByHand, ADragOfTheSliderTurnsIt) {
  EXPECT_FALSE(bench_.workbench().marks().all().contains("slider.environment_turn"));
  run("analyse.environment");
  const auto before = picture();
  ASSERT_TRUE(bench_.workbench().marks().all().contains("slider.environment_turn"));
  const Marks::Rect slider = bench_.workbench().marks().all().at("slider.environment_turn");
  const double middle = slider.y + slider.height / 2.0;
  bench_.move(slider.x + 8.0, middle);
  bench_.press();
  bench_.move(slider.x + slider.width / 2.0, middle);
  bench_.release();
  EXPECT_NEAR(editor().settings.environment.turn, 180, 20);
  EXPECT_NE(picture(), before);
  EXPECT_FALSE(editor().history.dirty());
}

TEST_F(EnvironmentByHand, NumbersStandBesideTheirSlidersAndCanBeTyped) {
  run("analyse.environment");
  const auto& marks = bench_.workbench().marks().all();
  const Marks::Rect row = marks.at("combo.environment");
  for (const char* id : {"slider.environment_turn", "slider.environment_exposure"}) {
    const Marks::Rect track = marks.at(id);
    constexpr double least_number = 24;  // pixels
    EXPECT_LT(track.x + track.width, row.x + row.width - least_number) << id;
    EXPECT_GT(track.width, row.width / 2.0) << id;
  }
  const Marks::Rect turn = marks.at("slider.environment_turn");
  bench_.move(turn.x + turn.width / 2.0, turn.y + turn.height / 2.0);
  bench_.hold(false, true, false);
  bench_.press();
  bench_.release();
  bench_.hold(false, false, false);
  bench_.enter("90");
  EXPECT_NEAR(editor().settings.environment.turn, 90, 1e-9);
}

TEST_F(EnvironmentByHand, TwentyFourStepsAreAWholeTurn) {
  run("analyse.environment");
  const auto before = picture();
  for (int i = 0; i < 6; ++i) run("environment.turn_right");
  EXPECT_EQ(editor().settings.environment.turn, 90);
  EXPECT_NE(picture(), before);
  for (int i = 0; i < 18; ++i) run("environment.turn_right");
  EXPECT_EQ(editor().settings.environment.turn, 0);
  EXPECT_EQ(picture(), before);
  run("environment.turn_left");
  EXPECT_EQ(editor().settings.environment.turn, 345);
}

TEST_F(EnvironmentByHand, AMissingFileIsToldOnceAndTheStudioShown) {
  run("environment.studio");
  const auto studio = picture();
  editor().settings.environment.file = (folder.path() / "gone.hdr").string();
  editor().show_environment(EnvironmentKind::file);
  settle();
  settle();
  EXPECT_EQ(notices("gone.hdr"), 1U);
  EXPECT_EQ(picture(), studio);
  EXPECT_EQ(editor().settings.environment.kind, EnvironmentKind::file) << "what was chosen stays chosen";
  // It is back, and chosen again.
  Image red(64, 32);
  for (std::size_t i = 0; i < red.rgba.size(); i += 4) red.rgba[i] = red.rgba[i + 3] = 255;
  ASSERT_TRUE(write_png(folder.path() / "gone.hdr", red).ok()) << "what counts is what it holds";
  editor().show_environment(EnvironmentKind::file);
  settle();
  EXPECT_EQ(notices("gone.hdr"), 1U);
  EXPECT_NE(picture(), studio);
}

TEST_F(EnvironmentByHand, ThePictureFileIsAskedForInADialog) {
  run("environment.file");
  EXPECT_TRUE(bench_.workbench().files().is_open());
}

}  // namespace
}  // namespace hariko

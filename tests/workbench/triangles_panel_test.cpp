// The panel of triangles by hand: over the surface or alone, tolerances that are dragged, maps of errors, a
// search that is stopped, four pictures and back.

#include <cstdlib>
#include <string>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class TrianglesPanel : public ::testing::Test, protected ProgramHands {
 protected:
  void SetUp() override {
    open_sample("fig2");
    smooth_ = picture();
    press({"Ctrl+Alt+T"});
    wait();
    ASSERT_GT(meshed(), 0);
  }
  Image picture() { return bench().renderer().read(0); }
  /// Share of the pixels in the middle of two pictures that differ.
  static double differing(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height) return 1;
    constexpr int alike = 5;  // out of 255
    int all = 0, others = 0;
    for (int y = a.height / 4; y < 3 * a.height / 4; ++y)
      for (int x = a.width / 4; x < 3 * a.width / 4; ++x) {
        bool same = true;
        for (int c = 0; c < 3; ++c)
          same = same && std::abs(int(a.pixel(x, y)[c]) - int(b.pixel(x, y)[c])) <= alike;
        ++all;
        others += same ? 0 : 1;
      }
    return double(others) / all;
  }
  bool shows(const std::string& mark) { return marks().contains(mark); }
  /// Number of triangles that the panel tells; 0 where it has no mesh.
  int count() {
    const std::string prefix = "meshing.count.";
    const auto found = marks_of(prefix);
    return found.size() == 1 ? std::stoi(found[0].substr(prefix.size())) : 0;
  }
  /// Clicks what asks for another mesh, and waits for it.
  void remesh(const std::string& mark) {
    const int before = meshed();
    click(mark);
    wait();
    EXPECT_GT(meshed(), before) << mark;
  }
  /// Takes the slider of the distance, and holds it further to the left.
  void begin_to_drag_the_distance() {
    const Marks::Rect slider = marks().at("meshing.distance");
    const double height = slider.y + slider.height / 2.0;
    begin_drag({slider.x + 0.55 * slider.width, height}, {slider.x + 0.35 * slider.width, height});
    wait();
  }

  Image smooth_;  ///< before the panel opened
};

TEST_F(TrianglesPanel, TheirEdgesLieOverTheSurfaceAndTheyStandAloneInItsPlace) {
  EXPECT_GT(count(), 50);
  const Image over = picture();
  const int made = meshed();
  click("meshing.place.1");
  wait();
  EXPECT_GT(differing(over, picture()), 0.02);
  click("meshing.place.0");
  wait();
  EXPECT_LT(differing(over, picture()), 0.01);
  EXPECT_EQ(meshed(), made) << "a choice of what is shown made another mesh";

  click("meshing.close");
  wait();
  EXPECT_FALSE(shows("meshing.compare")) << "the panel stayed";
  EXPECT_LT(differing(smooth_, picture()), 0.01) << "the smooth surface is not back";
}

TEST_F(TrianglesPanel, TracksOfTheTolerancesHaveOneLength) {
  const Marks::Rect first = marks().at("meshing.distance");
  for (const char* id : {"normal", "fold", "luminance", "edge", "angle"}) {
    const Marks::Rect other = marks().at(std::string("meshing.") + id);
    EXPECT_EQ(other.x, first.x) << id;
    EXPECT_EQ(other.width, first.width) << id;
  }
}

TEST_F(TrianglesPanel, ASmallerDistanceMakesMoreOfThemWhileItIsDragged) {
  const int first = count();
  const std::size_t steps = editor().history.position();
  begin_to_drag_the_distance();
  const int finer = count();
  EXPECT_GT(finer, first);
  bench().release();
  wait();
  EXPECT_EQ(count(), finer);
  EXPECT_EQ(editor().history.position(), steps) << "a tolerance made a step";
}

TEST_F(TrianglesPanel, EveryErrorHasAMapAndAMarkWhereItIsTheLargest) {
  EXPECT_FALSE(shows("meshing.histogram"));
  for (const char* kind : {"1", "2", "3"}) {
    click(std::string("meshing.show.") + kind);
    wait();
    EXPECT_TRUE(shows("meshing.histogram")) << kind;
    EXPECT_TRUE(shows("meshing.largest")) << kind;
  }
  // Another criterion, beside the first.
  remesh("meshing.normal.on");
  EXPECT_TRUE(editor().meshing.result->settings.of(MeshCriterion::normal).on);
  EXPECT_TRUE(editor().meshing.result->settings.of(MeshCriterion::distance).on);
}

TEST_F(TrianglesPanel, ASearchForFewerThatIsStoppedLeavesTheMeshOfBefore) {
  begin_to_drag_the_distance();
  bench().release();
  wait();
  const int before = count();
  click("meshing.optimise");
  click("meshing.stop");
  wait();
  EXPECT_TRUE(shows("meshing.stopped"));
  EXPECT_EQ(count(), before);
  remesh("meshing.optimise");
  EXPECT_FALSE(shows("meshing.stopped"));
  EXPECT_EQ(count(), before);
}

TEST_F(TrianglesPanel, FourPicturesCompareMeshesAndGoAgain) {
  remesh("meshing.compare");
  EXPECT_EQ(marks_of("meshing.picture.").size(), 4U);
  remesh("meshing.compare");
  EXPECT_TRUE(marks_of("meshing.picture.").empty());
}

}  // namespace
}  // namespace hariko::test

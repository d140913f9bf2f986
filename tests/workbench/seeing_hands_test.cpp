// Ways of looking by hand, through the whole interface: maps with their ranges, materials, marks, combs,
// tensions and sections, by panel, legend and keys.

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

/// A window that is high enough for all rows of the properties.
class SeeingByHand : public ::testing::Test, protected ProgramHands {
 protected:
  SeeingByHand() : ProgramHands(Begin::start_page, std::make_shared<TemporaryFolder>(), {1280, 1600}) {}
  void SetUp() override {
    open_sample("fig5d");
    ASSERT_TRUE(editor().active_object() && editor().active_object()->polyhedron()) << notice();
    ASSERT_EQ(surface_error(), "");
  }
  const DisplaySettings& display() { return editor().active_object()->display; }
};

TEST_F(SeeingByHand, MaterialsAndMapsOfAnObjectAreStepsAndLooksAreNone) {
  choose("material", 1);
  wait_for_step(1, "Material");
  // The map of all surfaces is no step; as the object's own it is one.
  press({"Alt+Z"});
  wait_for_step(1, "Material");
  EXPECT_TRUE(marks().contains("combo.lock"));
  press({"Alt+Z"});
  wait();
  EXPECT_FALSE(marks().contains("combo.lock"));
  choose("map", 2);
  wait_for_step(2, "Map Zebra");
  EXPECT_EQ(display().map, SurfaceMap::zebra);
  choose("lock", 1);
  EXPECT_EQ(static_cast<int>(editor().view.zebra.lock), 1);
  ASSERT_TRUE(marks().contains("ball.stripes"));
  const Vector3 before = editor().view.zebra.direction;
  const Vector2 ball = middle_of("ball.stripes");
  drag(ball, ball + Vector2(14, -10));
  EXPECT_FALSE(editor().view.zebra.direction == before) << "the stripes stay";
  wait_for_step(2, "Map Zebra");
}

TEST_F(SeeingByHand, RangesAreTypedInTheLegendChosenAndReset) {
  choose("map", 3);
  wait_for_step(1, "Map Gaussian curvature");
  ASSERT_TRUE(marks().contains("legend.high"));
  click("legend.high");
  frames(4);
  type("2.5");
  press({"Enter"});
  wait_for_step(2, "Range of the map");
  EXPECT_EQ(range_of(display(), SurfaceMap::gaussian).high, 2.5);
  EXPECT_TRUE(marks().contains("field.range_low")) << "a typed range shows its fields";
  click("legend.mode");
  click("legend.mode.2");
  wait();
  EXPECT_EQ(editor().history.position(), 3U);
  const Vector2 low = middle_of("legend.low");
  bench().move(low.x(), low.y());
  bench().press(1);
  bench().release(1);
  wait();
  EXPECT_EQ(editor().history.position(), 4U) << "the right button resets nothing";
  EXPECT_FALSE(marks().contains("field.range_low")) << "the fields of a typed range stayed";
}

TEST_F(SeeingByHand, MarksCombsAndTensionsHaveKeysAndAreSteps) {
  press({"Alt+E"});
  wait_for_step(1, "Edge continuity");
  EXPECT_TRUE(display().marks);
  press({"Alt+C"});
  wait_for_step(2, "Curvature combs");
  EXPECT_TRUE(display().combs.shown);
  press({"Alt+T"});
  wait_for_step(3, "Show tensions");
  EXPECT_TRUE(display().tensions);
  ASSERT_TRUE(marks().contains("combs.longer"));
  ASSERT_LT(marks().at("combs.longer").y, 1500) << "the row is out of sight";
  const double scale = display().combs.scale;
  click("combs.longer");
  wait_for_step(4, "Curvature combs");
  EXPECT_EQ(display().combs.scale, 2 * scale);
}

TEST_F(SeeingByHand, TheSectionBelongsToTheViewAndHasTwoSides) {
  press({"Alt+S"});
  wait();
  ASSERT_TRUE(marks().contains("slider.section_offset"));
  ASSERT_TRUE(marks().contains("check.section_flipped"));
  ASSERT_LT(marks().at("check.section_flipped").y, 1500) << "the row is out of sight";
  const Image one = bench().renderer().read(0);
  click("check.section_flipped");
  wait();
  EXPECT_TRUE(editor().view.section.flipped);
  const Image other = bench().renderer().read(0);
  ASSERT_EQ(one.rgba.size(), other.rgba.size());
  std::size_t changed = 0;
  for (std::size_t i = 0; i < one.rgba.size(); i += 4) changed += one.rgba[i] != other.rgba[i] ? 1 : 0;
  EXPECT_GT(changed, 5000U) << "the other side of the section looks the same";
  EXPECT_EQ(editor().history.position(), 0U) << "the section made a step";
  choose("wire", 2);
  wait_for_step(1, "Lines over the surface");
}

}  // namespace
}  // namespace hariko::test

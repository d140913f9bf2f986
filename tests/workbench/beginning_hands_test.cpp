// Beginnings from the start page: a first shape with its numbers, and the guide, left and taken up again.

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class FromNothing : public ::testing::Test, protected ProgramHands {
 protected:
  FromNothing() : ProgramHands(Begin::start_page) {}
  Index vertices() { return editor().active_object()->polyhedron()->polyhedron.vertex_count(); }
};

TEST_F(FromNothing, AShapeMakesADocumentAndItsNumbersStayInItsStep) {
  menu("Add", "add.torus");
  wait_for_step(1, "Add torus");
  ASSERT_TRUE(editor().active_object() && editor().active_object()->polyhedron());
  EXPECT_EQ(vertices(), 32U) << "8 by 4";
  enter("segments", "12");
  wait_for_step(1, "Add torus");
  EXPECT_EQ(vertices(), 48U);
  press({"Ctrl+Z"});
  wait();
  EXPECT_EQ(editor().history.position(), 0U);
  EXPECT_TRUE(editor().document().objects.empty());
  press({"Ctrl+Y"});
  wait_for_step(1, "Add torus");
  EXPECT_EQ(vertices(), 48U) << "redo gives another torus";
  // Elements are selected, and all of them cannot go.
  press({"Ctrl+A", "Del"});
  wait_for_step(1, "Add torus");
  EXPECT_EQ(vertices(), 48U);
}

TEST_F(FromNothing, ALiveMirrorTakesHalfOfAShapeAndGivesItBack) {
  menu("Add", "add.torus");
  wait();
  enter("segments", "12");
  wait_for_step(1, "Add torus");
  ASSERT_EQ(vertices(), 48U);
  const auto mirror = [&](const char* command) {
    click("menu.Mesh");
    click("menu.Mirror");
    click(std::string("command.mirror.") + command);
  };
  mirror("live_x");
  wait_for_step(2, "Live mirror");
  EXPECT_LT(vertices(), 48U) << "the half has all vertices";
  EXPECT_EQ(surface_error(), "");
  mirror("apply");
  wait_for_step(3, "Apply live mirror");
  EXPECT_EQ(vertices(), 48U);
  EXPECT_EQ(surface_error(), "");
}

TEST_F(FromNothing, TheGuideGoesOnWhereItWasLeft) {
  click("start.guide");
  EXPECT_TRUE(marks().contains("guide.step.0"));
  click("guide.box");
  wait();
  EXPECT_TRUE(marks().contains("guide.step.1"));
  press({"1"});
  const Vector2 corner = nearest_corner();
  drag(corner, corner + Vector2(40, 60));
  wait();
  EXPECT_TRUE(marks().contains("guide.step.2"));
  ASSERT_TRUE(marks().contains("slider.alpha"));
  const Marks::Rect slider = marks().at("slider.alpha");
  const double middle = slider.y + slider.height / 2.0;
  drag({slider.x + 8.0, middle}, {slider.x + 0.6 * slider.width, middle});
  wait();
  EXPECT_TRUE(marks().contains("guide.step.3"));
  click("guide.leave");
  EXPECT_TRUE(marks_of("guide.step.").empty());
  menu("Help", "help.guide");
  wait();
  EXPECT_TRUE(marks().contains("guide.step.3")) << "the place is not kept";
  press({"2", "Ctrl+A", "C"});
  wait();
  EXPECT_TRUE(marks().contains("guide.step.4"));
  // The map of the object counts as that of the view does.
  choose("map", 2);
  wait();
  EXPECT_EQ(editor().history.undo_label(), "Map Zebra");
  EXPECT_TRUE(marks().contains("guide.step.5"));
}

}  // namespace
}  // namespace hariko::test

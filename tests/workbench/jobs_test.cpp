// Whole jobs of modelling done by hand, from an empty document to files, with a count of what the hands do.

#include <filesystem>

#include "core/cad/kernel/cad_file.hpp"
#include "core/document/object_box.hpp"
#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class Jobs : public ::testing::Test, protected ProgramHands {
 protected:
  void save_under(const char* name) {
    press({"Ctrl+S"});
    name_file(name);
    wait();
    ASSERT_TRUE(std::filesystem::exists(folder() / name)) << notice();
  }
};

/// A computer mouse: a body of 62 x 110 x 36 mm, symmetric, lower at its ends and with a waist, a sharp seam
/// and a tense nose, looked at with zebra, saved and written as STEP.
TEST_F(Jobs, AMouseTakesAtMostSixtyActions) {
  click("menu.Add");
  click("command.add.box");
  wait();
  click("field.width");
  type("62");
  press({"Tab"});
  type("110");
  press({"Tab"});
  type("36");
  press({"Enter"});
  click("combo.mirror");
  click("choice.mirror.1");
  wait();
  bench().move(400, 880);
  press({"Home"});
  wait();

  // Two cuts across, where the body is to be bent.
  const Vector2 edge = curve_near({31, 0, 18});
  bench().move(edge.x(), edge.y());
  press({"Ctrl+R"});
  wheel(1);
  click(edge);
  click(edge);
  wait();
  ASSERT_EQ(editor().history.undo_label(), "2 loop cuts");

  // From the side: the back lower, the front lower still.
  press({"Num 3", "1"});
  wait();
  const auto shape = [&](const Vector3& from, const Vector3& to, std::initializer_list<const char*> keys,
                         const char* amount) {
    drag(pixel(from), pixel(to));
    EXPECT_FALSE(editor().selection.of_active().vertices.empty());
    press(keys);
    type(amount);
    press({"Enter"});
    wait();
  };
  shape({0, 80, 45}, {0, 40, 8}, {"G", "Z"}, "-8");
  shape({0, -80, 45}, {0, -40, 8}, {"G", "Z"}, "-14");
  // From above: a waist.
  press({"Num 7"});
  wait();
  shape({-60, -30, 0}, {60, -8, 0}, {"S", "X"}, "0.85");

  // The seam and the nose.
  press({"Num 0", "Ctrl+Shift+A", "2"});
  wait();
  click(curve_near({31, 0, 18}), 2);
  press({"C"});
  press({"1"});
  wait();
  const PolyhedronSource& source = *editor().active_object()->polyhedron();
  VertexId nose{};
  double least = 1e300;
  for (Index v = 0; v < source.polyhedron.vertex_count(); ++v) {
    const Vector3 at = source.origin + source.polyhedron.position(v);
    if ((at - Vector3(31, -55, 4)).norm() < least)
      least = (at - Vector3(31, -55, 4)).norm(), nose = source.polyhedron.vertex_id(v);
  }
  click(pixel(*place_of(editor().document(), {editor().selection.active, element_of(nose)})));
  EXPECT_EQ(editor().selection.of_active().vertices, std::set<VertexId>{nose});
  press({"T"});
  type("3");
  press({"Enter"});
  wait();

  // Looked at, saved and written for CAD.
  press({"Alt+Z"});
  drag({500, 700}, {620, 660}, 2);
  press({"V", "V", "Alt+Z"});
  save_under("mouse.hariko");
  if (!why_no_cad_files()) {
    click("menu.File");
    click("command.file.export_cad");
    name_file("mouse.step");
    EXPECT_EQ(exported(), folder() / "mouse.step");
  }

  const Shaping& shaping = *editor().active_object()->polyhedron()->shaping;
  EXPECT_GE(shaping.crease.size(), 2U);
  EXPECT_EQ(shaping.alpha.get_or(nose, 0), 3);
  EXPECT_TRUE(editor().active_object()->polyhedron()->mirror);
  // Creases and tension came after the size that was typed.
  EXPECT_NEAR(world_box(*editor().active_object()).sizes().y(), 110, 15);
  expect_at_most(60, "mouse");
}

/// A tube over three sections of given sizes, one of them scaled afterwards, closed at its ends.
TEST_F(Jobs, ATubeOfThreeSectionsTakesAtMostForty) {
  click("menu.Skin");
  click("command.skin.draw");
  wait();
  // The path on the ground.
  for (const Vector3& at : {Vector3(-80, -20, 0), Vector3(0, 20, 0), Vector3(80, -20, 0)}) click(pixel(at));
  press({"Enter"});
  wait();
  const auto ellipse = [&](const char* width, const char* height) {
    press({"E"});
    type(width);
    press({"Tab"});
    type(height);
    press({"Enter", "Enter"});
    wait();
  };
  ellipse("40", "25");
  ellipse("30", "20");
  ASSERT_EQ(editor().history.undo_label(), "Draw skin") << hint();
  press({"Home"});
  wait();

  click("menu.Skin");
  click("command.skin.draw_section");
  const Skin& two = *editor().active_object()->skin()->skin;
  click(pixel(evaluate(two.path, 0.5).position));
  wait();
  ellipse("60", "30");
  ASSERT_EQ(editor().history.undo_label(), "Draw section") << hint();
  // The section just drawn is selected.
  press({"S"});
  type("1.2");
  press({"Enter"});
  wait();
  EXPECT_EQ(editor().history.undo_label().substr(0, 5), "Scale");
  click("combo.skin_caps");
  click("choice.skin_caps.1");
  press({"Alt+Z"});
  drag({500, 700}, {620, 660}, 2);
  save_under("tube.hariko");

  const Skin& skin = *editor().active_object()->skin()->skin;
  EXPECT_EQ(skin.sections.size(), 3U);
  for (const SkinSection& section : skin.sections) EXPECT_TRUE(section.closed);
  expect_at_most(40, "tube");
}

/// A curved panel from a closed curve with tilted normals.
TEST_F(Jobs, AnOutlineTakesAtMostFifteen) {
  click("menu.Add");
  click("command.add.outline");
  wait();
  for (const Vector3& at :
       {Vector3(-60, -40, 0), Vector3(60, -40, 0), Vector3(60, 40, 0), Vector3(-60, 40, 0)})
    click(pixel(at));
  press({"Enter"});
  wait();
  ASSERT_TRUE(editor().active_object() && editor().active_object()->outline());
  press({"Ctrl+A"});
  click("field.outline_tilt");
  type("30");
  press({"Enter"});
  wait();
  press({"Alt+Z"});
  save_under("panel.hariko");
  expect_at_most(15, "outline");
}

}  // namespace
}  // namespace hariko::test

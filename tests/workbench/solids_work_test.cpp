// Solids by hand: added from the menu and placed with the mouse, picked, dragged, changed in the properties,
// copied and deleted; the surface round them with its bodies, its plane of symmetry and its methods.

#include <imgui_internal.h>

#include <string>
#include <vector>

#include "tests/workbench/program_hands.hpp"

namespace hariko::test {
namespace {

class SolidsWork : public ::testing::Test, protected ProgramHands {
 protected:
  const std::vector<Solid>& solids() { return editor().active_object()->solids()->input->solids; }
  Vector3 place(const Solid& solid) { return editor().active_object()->transform.apply(solid.position); }
  Vector2 at(std::size_t number) { return pixel(place(solids().at(number))); }
  bool shows(const std::string& mark) { return marks().contains(mark); }
  void undo() {
    press({"Ctrl+Z"});
    wait();
  }
  void begin_to_place(const std::string& kind) {
    click("menu.Solids");
    click("menu.Place");
    click("command.solid.place_" + kind);
  }
};

TEST_F(SolidsWork, ThoseOfTheMenuJoinTheObjectAndAClickTakesOne) {
  open_sample("solids_one");
  std::size_t step = 0;
  for (const char* kind : {"sphere", "cylinder", "cone"}) {
    menu("Solids", (std::string("solid.") + kind).c_str());
    wait();
    expect_step(++step, std::string("Add ") + kind);
  }
  EXPECT_EQ(editor().document().objects.size(), 1U);
  ASSERT_EQ(solids().size(), 4U);
  press({"Home", "Ctrl+Shift+A"});
  wait();
  EXPECT_EQ(selected(), "nothing selected");
  click(at(1));
  EXPECT_EQ(selected(), "1 solid");
}

/// A box, a ball, a cylinder and a prism.
class FourSolids : public SolidsWork {
 protected:
  void SetUp() override {
    open_sample("solids_four");
    ASSERT_EQ(solids().size(), 4U);
  }
};

TEST_F(FourSolids, OneFollowsThePointerAndUndoPutsItBack) {
  click("solid.1");
  wait();
  EXPECT_TRUE(shows("field.solid.radius"));
  const Solid before = solids()[1];
  const Vector2 from = at(1), to = from + Vector2(-60, -90);
  drag(from, to);
  wait();
  expect_step(1, "Move solid");
  EXPECT_LT((at(1) - to).cwiseAbs().maxCoeff(), 12) << "it did not follow the pointer";
  undo();
  EXPECT_EQ(solids()[1], before);
}

TEST_F(FourSolids, TheNumbersOfARowThatIsClickedComeIntoSightBelowTheList) {
  const int before = marks().at("solid.2").y;
  click("solid.2");
  wait();
  EXPECT_EQ(marks().at("solid.2").y, before) << "the row went away from under the pointer";
  ASSERT_TRUE(shows("field.solid.x"));
  EXPECT_GT(marks().at("field.solid.x").y, marks().at("solid.3").y);
  const ImGuiWindow* panel = ImGui::FindWindowByName("Properties");
  EXPECT_LT(float(marks().at("field.solid.x").y), panel->Pos.y + panel->Size.y);
}

TEST_F(FourSolids, ADragAcrossTheOthersIsOneStepAndEndsWithASurface) {
  const Vector2 from = at(0), to = at(3);
  const Document before = editor().document();
  std::vector<Vector2> way;
  constexpr int steps = 25;
  for (int i = 0; i <= steps; ++i) way.push_back(from + double(i) / steps * (to - from));
  stroke(way);
  wait();
  expect_step(1, "Move solid");
  const SurfaceView* view = editor().view_of(editor().selection.active);
  EXPECT_TRUE(view && view->mesh);
  undo();
  EXPECT_EQ(editor().document(), before);
  EXPECT_EQ(surface_error(), "");
}

TEST_F(FourSolids, NumbersOfOneAndOfTheSurfaceAreSteps) {
  click(at(1));
  wait();
  enter("solid.radius", "0.3");
  wait();
  expect_step(1, "Size of solid");
  EXPECT_EQ(solids()[1].radius, 0.3);
  // Without a selection the rows of the surface come into sight.
  press({"Ctrl+Shift+A"});
  wait();
  EXPECT_EQ(selected(), "nothing selected");
  enter("rounding", "0.06");
  wait();
  expect_step(2, "Rounding of the surface");
  EXPECT_TRUE(shows("solids.contains"));
  for (const char* tightness : {"1", "0"}) {
    enter("tightness", tightness);
    wait();
    EXPECT_EQ(editor().history.undo_label(), "Tightness of the surface") << tightness;
  }
  EXPECT_EQ(editor().history.position(), 4U);
}

TEST_F(FourSolids, DelTakesTheSelectedOneOnly) {
  click("solid.0");
  const Vector2 aside = in_view(0.3, 0.9);
  bench().move(aside.x(), aside.y());
  press({"Del"});
  wait();
  expect_step(1, "Delete solid");
  ASSERT_EQ(solids().size(), 3U);
  for (const Solid& solid : solids()) EXPECT_NE(solid.id, 0U);
}

/// A box on the ground and a ball on the box, their sizes by drags; a cone by a click.
TEST_F(FourSolids, FurtherOnesArePlacedOnTheGroundAndOnEachOther) {
  const Vector2 ground = in_view(0.15, 0.75), far = in_view(0.85, 0.75);
  begin_to_place("box");
  drag(ground, ground + Vector2(50, 20));
  wait();
  expect_step(1, "Add box");
  EXPECT_EQ(selected(), "1 solid");
  ASSERT_EQ(solids().size(), 5U);
  const Vector2 box = at(4);
  EXPECT_NEAR(box.x(), ground.x(), 20);
  EXPECT_LT(box.y(), ground.y()) << "it does not stand there";
  begin_to_place("sphere");
  drag(box, box + Vector2(30, 0));
  wait();
  expect_step(2, "Add sphere");
  EXPECT_EQ(selected(), "1 solid");
  ASSERT_EQ(solids().size(), 6U);
  EXPECT_LT(depth(place(solids()[5])), depth(place(solids()[4]))) << "it is not on the side that was clicked";
  begin_to_place("cone");
  click(far);
  wait();
  expect_step(3, "Add cone");
  EXPECT_EQ(selected(), "1 solid");
  ASSERT_EQ(solids().size(), 7U);
  EXPECT_NEAR(at(6).x(), far.x(), 20);
  undo();
  EXPECT_EQ(solids().size(), 6U);
}

TEST_F(FourSolids, EscTakesBackTheOneThatIsBeingPlaced) {
  const Vector2 ground = in_view(0.15, 0.75);
  const Document before = editor().document();
  begin_to_place("cone");
  begin_drag(ground, ground + Vector2(40, 0));
  EXPECT_EQ(solids().size(), 5U);
  press({"Esc"});
  bench().release();
  frames(2);
  EXPECT_EQ(editor().document(), before);
  EXPECT_EQ(editor().history.position(), 0U);
}

TEST_F(FourSolids, ARowOfOneIsAdjustedWithinItsStep) {
  click(at(0));
  menu("Solids", "solid.row");
  wait();
  expect_step(1, "Row of solids");
  EXPECT_EQ(solids().size(), 7U);
  EXPECT_EQ(selected(), "3 solids");
  enter("copies", "2");
  wait();
  EXPECT_EQ(solids().size(), 6U);
  EXPECT_EQ(editor().history.position(), 1U);
  undo();
  EXPECT_EQ(solids().size(), 4U);
}

TEST_F(FourSolids, TheyBecomeAPolyhedronInOneStep) {
  menu("Solids", "solid.to_polyhedron");
  wait();
  expect_step(1, "Convert to polyhedron");
  ASSERT_EQ(editor().document().objects.size(), 2U);
  ASSERT_TRUE(editor().active_object()->polyhedron());
  EXPECT_GT(editor().active_object()->polyhedron()->polyhedron.vertex_count(), 4U);
  EXPECT_EQ(selected(), "nothing selected");
  undo();
  EXPECT_EQ(editor().document().objects.size(), 1U);
}

TEST_F(FourSolids, BodiesShowThroughTheSurfaceUntilAKeyHidesThem) {
  const auto picture = [this] { return bench().renderer().read(0).rgba; };
  const auto with_bodies = picture();
  press({"Alt+B"});
  wait();
  EXPECT_TRUE(picture() != with_bodies);
  press({"Alt+B"});
  wait();
  EXPECT_TRUE(picture() == with_bodies);
  EXPECT_EQ(editor().history.position(), 0U);
}

TEST_F(FourSolids, APlaneOfSymmetryIsOneStepAndHasARow) {
  choose("envelope_symmetry", 1);
  wait();
  expect_step(1, "Symmetry of the surface");
  EXPECT_TRUE(shows("solids.symmetric"));
  undo();
  EXPECT_FALSE(shows("solids.symmetric"));
}

TEST_F(FourSolids, TheMethodByCurvesIsOneStepAndHasRowsOfItsOwn) {
  EXPECT_TRUE(shows("field.rounding"));
  choose("envelope_method", 1);
  wait();
  expect_step(1, "Method of the surface");
  EXPECT_TRUE(shows("field.roundness"));
  EXPECT_FALSE(shows("field.rounding"));
  undo();
  EXPECT_TRUE(shows("field.rounding"));
}

}  // namespace
}  // namespace hariko::test

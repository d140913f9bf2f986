// Working in the panels: Tab through fields, rows that stay, tips beside the panel, sizes, many objects.

#include <imgui_internal.h>

#include "core/document/object_box.hpp"
#include "core/envelope/ball/tightness.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "ui/editor/object_size.hpp"

namespace hariko::test {
namespace {

class PanelHands : public BenchHands {
 protected:
  PanelHands() : BenchHands(Document()) {}
  void run(std::string_view id) {
    ASSERT_TRUE(bench_.workbench().commands().run(id).ran) << id;
    bench_.wait_for_surfaces();
  }
  /// Into a field by the mouse.
  void enter(const std::string& mark, std::string_view text) {
    bench_.click(mark);
    bench_.frame();
    bench_.type(text);
  }
  Vector3 size_of_active() {
    const Object& object = *editor().active_object();
    return own_box(editor(), object).sizes() * object.transform.scale;
  }
};

TEST_F(PanelHands, TabGoesThroughTheNumbersOfANewBox) {
  run("add.box");
  enter("field.width", "62");
  bench_.tap("Tab");
  bench_.type("110");
  bench_.tap("Tab");
  bench_.enter("36");
  const auto& numbers = editor().last_operation.numbers();
  ASSERT_GE(numbers.size(), 3U);
  EXPECT_EQ(numbers[0].value, 62);
  EXPECT_EQ(numbers[1].value, 110);
  EXPECT_EQ(numbers[2].value, 36);
  EXPECT_TRUE(world_box(*editor().active_object()).sizes().isApprox(Vector3(62, 110, 36), 1e-12));
}

TEST_F(PanelHands, ShiftTabGoesBack) {
  run("add.box");
  enter("field.depth", "50");
  bench_.tap("Shift+Tab");
  bench_.enter("40");
  EXPECT_EQ(editor().last_operation.numbers()[0].value, 40);
  EXPECT_EQ(editor().last_operation.numbers()[1].value, 50);
}

TEST_F(PanelHands, TabAfterEnterGoesOnFromTheFieldThatWasEntered) {
  run("add.box");
  enter("field.width", "62");
  bench_.tap("Enter");
  bench_.tap("Tab");
  bench_.enter("110");
  EXPECT_EQ(editor().last_operation.numbers()[0].value, 62);
  EXPECT_EQ(editor().last_operation.numbers()[1].value, 110);
}

TEST_F(PanelHands, ANewSolidHasOneBlockOfNumbersAndStaysSelected) {
  run("solid.box");
  ASSERT_TRUE(marks().contains("field.solid.width"));
  EXPECT_FALSE(marks().contains("field.width")) << "its numbers are there twice";
  enter("field.solid.width", "55");
  bench_.tap("Tab");
  bench_.enter("66");
  bench_.wait_for_surfaces();
  const Object& object = *editor().active_object();
  EXPECT_EQ(object.solids()->input->solids.front().size.x(), 55);
  EXPECT_EQ(object.solids()->input->solids.front().size.y(), 66);
  EXPECT_EQ(editor().selection.of(object.id).vertices.size(), 1U);
  EXPECT_TRUE(marks().contains("field.solid.width"));
}

/// A press in the view takes the number that was typed, and is not lost by it.
TEST_F(PanelHands, ADragRightAfterTypingMovesWhatItBeganOn) {
  run("solid.box");
  run("solid.sphere");
  const Solid before = editor().active_object()->solids()->input->solids.back();
  const std::size_t steps = editor().history.position();
  enter("field.solid.radius", "30");
  const ImVec2 corner = bench_.workbench().viewport().rect().min;
  const Vector2 at = Projector(editor().camera(), editor().viewport).project(before.position)->head<2>() +
                     Vector2(double(corner.x) - 8, double(corner.y) + 8);
  bench_.move(at.x(), at.y());
  bench_.press();
  for (int i = 1; i <= 4; ++i) bench_.move(at.x() + 15 * i, at.y() + 10 * i);
  bench_.release();
  bench_.frame();
  const Solid& after = editor().active_object()->solids()->input->solids.back();
  EXPECT_EQ(after.radius, 30) << "the number is lost";
  EXPECT_GT((after.position - before.position).norm(), 5) << "the drag is lost";
  EXPECT_EQ(editor().history.position(), steps + 2);
}

/// As large as suits what is there, and half of it outside.
TEST_F(PanelHands, NewSolidsFitThoseThatAreThereAndCanBeSeen) {
  for (const char* size : {"8", "100", "3000"}) {
    SCOPED_TRACE(size);
    editor().open(Document(), {});
    bench_.frame();
    run("solid.box");
    enter("field.solid.width", size);
    for (int i = 0; i < 2; ++i) {
      bench_.tap("Tab");
      bench_.type(size);
    }
    bench_.tap("Enter");
    run("solid.sphere");
    const std::vector<Solid>& solids = editor().active_object()->solids()->input->solids;
    ASSERT_EQ(solids.size(), 2U);
    const double width = solids[0].size.x();
    EXPECT_GE(solids[1].radius, 0.1 * width);
    EXPECT_LE(solids[1].radius, 0.5 * width);
    EXPECT_NEAR(solids[1].position.x(), width / 2, 1e-9 * width);
  }
}

TEST_F(PanelHands, ACopiedRowOfSolidsStaysSelectedWhileItsNumberIsChanged) {
  run("solid.sphere");
  run("solid.row");
  enter("field.copies", "5");
  bench_.tap("Enter");
  EXPECT_EQ(editor().active_object()->solids()->input->solids.size(), 6U);
  EXPECT_EQ(editor().selection.of(editor().selection.active).vertices.size(), 5U);
}

TEST_F(PanelHands, ALongListOfSolidsScrollsByItself) {
  run("solid.sphere");
  run("solid.row");
  enter("field.copies", "12");
  bench_.tap("Enter");
  bench_.frame();
  bench_.move(marks().at("solid.4").x + 20, marks().at("solid.4").y + 5);
  for (int i = 0; i < 4; ++i) bench_.frame();
  const int row = marks().at("solid.4").y, number = marks().at("field.solid.x").y;
  bench_.wheel(-2);
  for (int i = 0; i < 6; ++i) bench_.frame();
  EXPECT_LT(marks().at("solid.4").y, row);
  EXPECT_EQ(marks().at("field.solid.x").y, number) << "the panel ran after the row";
}

/// As work that ends beside the event loop takes the rows of the last step away.
TEST_F(PanelHands, ANumberWhoseFieldGoesIsNotTakenByTheNextOneLikeIt) {
  run("solid.sphere");
  run("solid.row");
  enter("field.copies", "7");
  editor().commit(rename_object(editor().history.current(), editor().selection.active, "Pebbles"), "Rename");
  for (int i = 0; i < 3; ++i) bench_.frame();
  ASSERT_FALSE(marks().contains("field.copies"));
  run("solid.row");
  ASSERT_TRUE(marks().contains("field.copies"));
  bench_.click("field.solid.x");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_EQ(editor().last_operation.numbers()[0].value, 3);
}

TEST_F(PanelHands, ABarBridgesTwoSolidsAndIsSelected) {
  run("solid.sphere");
  run("solid.row");
  enter("field.copies", "2");
  bench_.tap("Enter");
  run("solid.bridge");
  ASSERT_TRUE(marks().contains("field.solid.radius"));
  enter("field.solid.radius", "1.5");
  bench_.tap("Enter");
  const std::vector<Solid> solids = editor().active_object()->solids()->input->solids;
  ASSERT_EQ(solids.size(), 4U);
  EXPECT_EQ(solids.back().kind, SolidKind::capsule);
  EXPECT_EQ(solids.back().radius, 1.5);
  EXPECT_EQ(solids.back().bridge, (Bridge{{solids[1].id, solids[2].id}, {}})) << "the copies are selected";
  bench_.click("check.own_ball");
  bench_.frame();
  ASSERT_TRUE(marks().contains("field.solid.ball_radius"));
  enter("field.solid.ball_radius", "0.75");
  bench_.tap("Enter");
  EXPECT_EQ(editor().active_object()->solids()->input->solids.back().bridge->ball_radius, 0.75);
  EXPECT_TRUE(marks().contains("solid.outside")) << "nothing says how far faces lie outside";
}

TEST_F(PanelHands, RowsUnderThePointerStayWhenRowsAboveGo) {
  run("add.box");
  ASSERT_TRUE(marks().contains("field.width")) << "the numbers of the step stand above";
  const Marks::Rect before = marks().at("combo.map");
  bench_.move(before.x + before.width / 2.0, before.y + before.height / 2.0);
  bench_.frame();
  // Any further step ends the adjusting of the one before.
  editor().commit(rename_object(editor().history.current(), editor().selection.active, "Pebble"), "Rename");
  for (int i = 0; i < 4; ++i) bench_.frame();
  EXPECT_FALSE(marks().contains("field.width"));
  EXPECT_EQ(marks().at("combo.map").y, before.y);
  // Away from the panel all is as usual.
  bench_.move(400, 500);
  for (int i = 0; i < 4; ++i) bench_.frame();
  EXPECT_LT(marks().at("combo.map").y, before.y);
}

/// Rows of the surface's state went while it was made anew, and those below jumped.
TEST_F(PanelHands, RowsStayWhileASolidIsDragged) {
  run("solid.box");
  run("solid.sphere");
  ASSERT_TRUE(marks().contains("solids.contains"));
  const auto rows = [&] {
    std::map<std::string, int> out;
    for (const auto& [mark, rect] : marks())
      if (mark.starts_with("field.") || mark.starts_with("solids.") || mark.starts_with("combo."))
        out[mark] = rect.y;
    return out;
  };
  const auto before = rows();
  const Solid ball = editor().active_object()->solids()->input->solids.back();
  const ImVec2 corner = bench_.workbench().viewport().rect().min;
  const Vector2 at = Projector(editor().camera(), editor().viewport).project(ball.position)->head<2>() +
                     Vector2(double(corner.x) - 8, double(corner.y) + 8);
  bench_.move(at.x(), at.y());
  bench_.press();
  for (int i = 1; i <= 6; ++i) {
    bench_.move(at.x() + 12 * i, at.y() + 8 * i);
    EXPECT_EQ(rows(), before) << "step " << i;
  }
  bench_.release();
  bench_.frame();
  EXPECT_EQ(rows(), before) << "released";
  bench_.wait_for_surfaces();
  EXPECT_EQ(rows(), before) << "ready";
}

/// The tip that is shown now; null for none.
const ImGuiWindow* tip() {
  for (const ImGuiWindow* window : GImGui->Windows)
    if ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->WasActive && !window->Hidden)
      return window;
  return nullptr;
}

TEST_F(PanelHands, TipsStandBesideThePanelAndNotWhileOneTypes) {
  run("add.box");
  for (const char* mark : {"field.size.x", "label.size.x", "combo.map", "check.split_concave"}) {
    const Marks::Rect rect = marks().at(mark);
    bench_.move(rect.x + rect.width / 2.0, rect.y + rect.height / 2.0);
    for (int i = 0; i < 3; ++i) bench_.frame();
    const ImGuiWindow* shown = tip();
    if (std::string_view(mark) == "combo.map") continue;  // its label has the tip
    ASSERT_NE(shown, nullptr) << mark;
    const ImGuiWindow* panel = ImGui::FindWindowByName("Properties");
    EXPECT_LE(shown->Pos.x + shown->Size.x, panel->Pos.x) << mark;
    EXPECT_GE(shown->Pos.x, 0) << mark;
  }
  bench_.click("field.size.x");
  bench_.type("6");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_EQ(tip(), nullptr);
}

TEST_F(PanelHands, ATypedUnitIsNotShownAsMetres) {
  run("add.box");
  editor().mode = ElementMode::object;
  editor().selection.select({editor().selection.active, element_of(editor().selection.active)},
                            Selection::How::replace);
  const auto moved = [&] { return editor().document().objects.front()->transform.translation.z(); };
  bench_.move(500, 400);
  for (const char* key : {"G", "Z"}) bench_.key(key);
  bench_.key("8");
  EXPECT_NEAR(moved(), 8, 1e-12);
  const auto letter = [&](char32_t c) {
    bench_.workbench().key({KeyChord::parse("M").value(), c});
    bench_.frame();
  };
  letter(U'm');
  EXPECT_NEAR(moved(), 8, 1e-12) << "metres on the way to millimetres";
  letter(U'm');
  EXPECT_NEAR(moved(), 8, 1e-12);
  bench_.key("Enter");
  EXPECT_NEAR(moved(), 8, 1e-12);
  // Enter says that metres are meant.
  for (const char* key : {"G", "Z", "8"}) bench_.key(key);
  letter(U'm');
  bench_.key("Enter");
  EXPECT_NEAR(moved(), 8008, 1e-9);
}

TEST_F(PanelHands, ManyObjectsHaveTheirCommonPropertiesTogether) {
  run("add.box");
  run("object.duplicate");
  run("object.duplicate");
  editor().mode = ElementMode::object;
  for (const auto& object : editor().document().objects)
    editor().selection.select({object->id, element_of(object->id)}, Selection::How::add);
  bench_.frame();
  DisplaySettings display = editor().active_object()->display;
  display.points = !display.points;
  editor().commit(set_display(editor().history.current(), editor().selection.active, display), "Points");
  for (const auto& object : editor().document().objects)
    editor().selection.select({object->id, element_of(object->id)}, Selection::How::add);
  bench_.frame();
  ASSERT_TRUE(marks().contains("combo.map"));
  ASSERT_TRUE(marks().contains("combo.mirror"));
  ASSERT_TRUE(marks().contains("field.colour"));
  // Mixed values become the same for all.
  bench_.click("check.points");
  bench_.frame();
  const bool points = editor().document().objects.front()->display.points;
  for (const auto& object : editor().document().objects) EXPECT_EQ(object->display.points, points);
  bench_.click("combo.map");
  bench_.frame();
  bench_.click("choice.map.2");
  bench_.frame();
  for (const auto& object : editor().document().objects)
    EXPECT_EQ(object->display.map, SurfaceMap::zebra) << object->name;
}

TEST_F(PanelHands, ListsAnswerToArrowsAndEnter) {
  run("add.box");
  bench_.click("combo.map");
  for (int i = 0; i < 3; ++i) bench_.frame();
  ASSERT_TRUE(marks().contains("choice.map.1"));
  bench_.tap("Down");
  bench_.tap("Enter");
  for (int i = 0; i < 3; ++i) bench_.frame();
  EXPECT_EQ(editor().active_object()->display.map, SurfaceMap::patches);
  EXPECT_FALSE(marks().contains("choice.map.1")) << "the list is still open";
}

TEST_F(PanelHands, TheSizeIsThatOfTheSurfaceAndCanBeTyped) {
  for (const double unit : {1e-3, 1.0, 1e5}) {
    SCOPED_TRACE(unit);
    Document document;
    editor().open(document, {});
    bench_.move(600, 400);  // rows stay below a pointer in the panel
    bench_.frame();
    run("add.box");
    const ObjectId id = editor().selection.active;
    Similarity place = editor().active_object()->transform;
    place.scale = unit;
    place.translation = unit * Vector3(1e6, -1e6, 1e6);
    editor().commit(set_transform(editor().history.current(), id, place), "Place");
    bench_.wait_for_surfaces();
    const Vector3 before = size_of_active();
    EXPECT_LT((before - unit * Vector3::Constant(100)).cwiseAbs().maxCoeff(), unit * 80) << "not of the cage";
    const double wanted = 0.62 * before.x();
    enter("field.size.x", exact_text(plain_quantity(9, 1), wanted));
    bench_.tap("Enter");
    bench_.wait_for_surfaces();
    const Vector3 after = size_of_active();
    EXPECT_NEAR(after.x(), wanted, 2e-5 * wanted);
    editor().transform.proportional_size = true;
    bench_.frame();
    enter("field.size.y", exact_text(plain_quantity(9, 1), 2 * after.y()));
    bench_.tap("Enter");
    bench_.wait_for_surfaces();
    EXPECT_TRUE(size_of_active().isApprox(2 * after, 1e-5)) << size_of_active().transpose();
    editor().transform.proportional_size = false;
  }
}

TEST_F(PanelHands, EveryWayToBeginHasTheSameSize) {
  for (const Unit unit : {Unit::millimetre, Unit::metre}) {
    SCOPED_TRACE(to_string(unit));
    editor().settings.unit = unit;
    bench_.workbench().commands().run("file.new_from_box");
    bench_.wait_for_surfaces();
    const double millimetres = millimetres_per(unit);
    EXPECT_NEAR(world_box(*editor().active_object()).sizes().x() * millimetres, 100, 1e-9);
    EXPECT_EQ(editor().active_object()->polyhedron()->frames, Frames::metric);
    editor().history.mark_saved(editor().history.serial());
    bench_.workbench().commands().run("file.new");
    bench_.frame();
    bench_.frame();
    EXPECT_NEAR(editor().camera().view_height() * millimetres, 300, 1e-6) << "an empty view";
    bench_.workbench().commands().run("add.box");
    bench_.frame();
    EXPECT_NEAR(world_box(*editor().active_object()).sizes().x() * millimetres, 100, 1e-9);
    EXPECT_EQ(editor().active_object()->polyhedron()->frames, Frames::metric);
    editor().history.mark_saved(editor().history.serial());
  }
}

TEST_F(PanelHands, TheSurfaceIsLaidOnTheFacesAndSaysWhatSticksOut) {
  run("solid.box");
  run("select.none");
  ASSERT_TRUE(marks().contains("solids.contains"));
  const auto settings = [&] { return editor().active_object()->solids()->input->settings; };
  const auto patches = [&] { return editor().view_of(editor().selection.active)->surface.patch_count(); };
  const Index before = patches();
  bench_.click("check.on_faces");
  bench_.wait_for_surfaces();
  EXPECT_TRUE(settings().on_faces);
  EXPECT_FALSE(marks().contains("solids.contains"));
  ASSERT_TRUE(marks().contains("solids.sticks_out"));
  const auto sticks_out = editor().view_of(editor().selection.active)->sticks_out;
  ASSERT_TRUE(sticks_out.has_value());
  EXPECT_GT(*sticks_out, 0.3 * settings().rounding);
  EXPECT_LT(*sticks_out, 3 * settings().rounding);
  bench_.click("check.finer_patches");
  bench_.wait_for_surfaces();
  EXPECT_TRUE(settings().finer_patches);
  EXPECT_GT(patches(), before);
  run("edit.undo");
  run("edit.undo");
  EXPECT_FALSE(settings().on_faces);
  EXPECT_EQ(patches(), before);
  EXPECT_TRUE(marks().contains("solids.contains"));
}

TEST_F(PanelHands, APropertyIsFoundByItsNameAndGetsTheKeyboard) {
  run("solid.box");
  run("property.tightness");
  for (int i = 0; i < 6; ++i) bench_.frame();
  EXPECT_FALSE(bench_.workbench().field_opening());
  bench_.enter("0.4");
  const EnvelopeInput& input = *editor().active_object()->solids()->input;
  const EnvelopeSettings& settings = input.settings;
  EXPECT_NEAR(tightness_of(settings.ball_radius, settings.rounding, solids_size(input.solids)), 0.4, 1e-12);
}

}  // namespace
}  // namespace hariko::test

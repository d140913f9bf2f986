// Arranging whole objects by hand: rows, rings, mirror images, copies that are moved at once, common sides,
// and steps that are made again.

#include <algorithm>

#include "core/document/object_box.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "tests/workbench/program_hands.hpp"
#include "ui/editor/object_size.hpp"

namespace hariko::test {
namespace {

class ARow : public ::testing::Test, protected ProgramHands {
 protected:
  const std::vector<std::shared_ptr<const Object>>& objects() { return editor().document().objects; }
};

TEST_F(ARow, OfTwentyBoxesTakesAtMostTwelveActions) {
  click("menu.Add");
  click("command.add.box");
  wait();
  press({"F3"});
  type("array in a row");
  press({"Enter"});
  wait();
  ASSERT_TRUE(marks().contains("field.array_count")) << notice();
  EXPECT_EQ(objects().size(), 3U);
  const double usual = objects()[1]->transform.translation.x();
  EXPECT_GT(usual, shown_box(editor(), *objects()[0]).sizes().x()) << "the first copies do not touch";
  click("field.array_count");
  type("20");
  press({"Tab"});
  type("130");
  press({"Enter"});
  wait();
  expect_at_most(12, "twenty boxes in a row");

  ASSERT_EQ(objects().size(), 20U);
  for (std::size_t i = 0; i < objects().size(); ++i) {
    EXPECT_EQ(objects()[i]->transform.translation, Vector3(130.0 * double(i), 0, 0));
    EXPECT_EQ(objects()[i]->name, i == 0 ? "Box" : "Box " + std::to_string(i + 1));
  }
  EXPECT_EQ(editor().selection.objects().size(), 20U) << "what is arranged is chosen";
  EXPECT_EQ(editor().history.position(), 2U) << "one step, whatever was adjusted";
  EXPECT_EQ(editor().history.undo_label(), "Array in a row");
  press({"Ctrl+Z"});
  EXPECT_EQ(objects().size(), 1U);
  press({"Ctrl+Shift+Z"});
  EXPECT_EQ(objects().size(), 20U);
}

class Arranging : public BenchHands {
 protected:
  void move_active(const Vector3& to) {
    Similarity place;
    place.translation = to;
    editor().commit(set_transform(editor().history.current(), editor().selection.active, place), "Place");
  }
  Vector3 place(std::size_t object) { return objects()[object]->transform.translation; }
};

TEST_F(Arranging, ARowOfARowIsAGrid) {
  run("object.array_row");
  enter("array_x", "5");
  run("object.array_row");
  enter("array_y", "7");
  enter("array_x", "0");
  ASSERT_EQ(objects().size(), 9U);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_TRUE(std::any_of(
          objects().begin(), objects().end(),
          [&](const auto& object) { return object->transform.translation == Vector3(5 * i, 7 * j, 0); }))
          << i << ", " << j;
}

/// Copies reached out of the view, and nothing showed them.
TEST_F(Arranging, CopiesComeIntoSight) {
  bench_.wait_for_surfaces();
  run("view.frame_all");
  for (int i = 0; i < 20; ++i) bench_.frame();
  for (const char* id : {"object.array_row", "object.mirror_copy_x", "object.array_ring"}) {
    SCOPED_TRACE(id);
    run(id);
    for (int i = 0; i < 20; ++i) bench_.frame();  // and the flight
    const Projector projector(editor().camera(), editor().viewport);
    for (const auto& object : objects()) {
      const auto at = projector.project(shown_box(editor(), *object).center());
      ASSERT_TRUE(at);
      EXPECT_TRUE(at->x() >= 0 && at->x() <= editor().viewport.width && at->y() >= 0 &&
                  at->y() <= editor().viewport.height)
          << object->name;
    }
  }
}

TEST_F(Arranging, NumbersThatAreRefusedChangeNothing) {
  run("object.array_row");
  const Document before = editor().document();
  enter("array_x", "0");
  EXPECT_EQ(editor().document(), before);
  ASSERT_FALSE(editor().notices().empty());
  EXPECT_EQ(editor().notices().back().kind, Notice::Kind::error);
  enter("array_count", "1");
  EXPECT_EQ(objects().size(), 2U) << "the nearest that can be";
}

TEST_F(Arranging, ARingHasItsAxisItsCentreAndItsAngle) {
  move_active({10, 0, 0});
  run("object.array_ring");
  EXPECT_EQ(objects().size(), 6U);
  enter("array_count", "4");
  EXPECT_LT((place(1) - Vector3(0, 10, 0)).norm(), 1e-12);
  choose("array_axis", 1);
  EXPECT_LT((place(1) - Vector3(0, 0, -10)).norm(), 1e-12);
  enter("array_angle", "-90");
  EXPECT_LT((place(3) - Vector3(0, 0, 10)).norm(), 1e-12) << "a part of a turn has copies at both ends";
  choose("array_centre", 1);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((place(i) - Vector3(10, 0, 0)).norm(), 1) << "about the middle of what is selected";
  EXPECT_EQ(editor().history.undo_label(), "Array around an axis");
  editor().undo();
  EXPECT_EQ(objects().size(), 1U);
}

TEST_F(Arranging, AMirroredCopyStandsBehindThePlane) {
  move_active({10, 3, 0});
  run("object.mirror_copy_x");
  ASSERT_EQ(objects().size(), 2U);
  EXPECT_EQ(place(1), Vector3(-10, 3, 0));
  enter("mirror_position", "20");
  EXPECT_EQ(place(1), Vector3(30, 3, 0));
  EXPECT_EQ(editor().selection.active, objects()[1]->id) << "the image is chosen";
  const Polyhedron &own = objects()[0]->polyhedron()->polyhedron,
                   &image = objects()[1]->polyhedron()->polyhedron;
  EXPECT_EQ(image.face_count(), own.face_count());
}

TEST_F(Arranging, DuplicateAndMoveIsOneStep) {
  const Document before = editor().document();
  bench_.move(600, 400);
  bench_.key("Shift+D");
  EXPECT_TRUE(bench_.workbench().viewport().tool_active());
  EXPECT_EQ(objects().size(), 2U) << "the copy is shown at once";
  for (const char* key : {"X", "7", "Enter"}) bench_.key(key);
  ASSERT_EQ(objects().size(), 2U);
  EXPECT_EQ(place(1), Vector3(7, 0, 0));
  EXPECT_EQ(objects()[1]->name, "Box 2");
  EXPECT_EQ(editor().history.position(), 1U);
  EXPECT_EQ(editor().history.undo_label(), "Duplicate and move");
  EXPECT_EQ(editor().selection.active, objects()[1]->id);
  // The lengths can be changed right afterwards.
  bench_.frame();
  enter("copies_y", "2");
  EXPECT_EQ(place(1), Vector3(7, 2, 0));
  EXPECT_EQ(editor().history.position(), 1U);
  // Again and again, each from the last.
  bench_.key("Shift+R");
  bench_.key("Shift+R");
  ASSERT_EQ(objects().size(), 4U);
  std::vector<double> places;
  for (const auto& object : objects()) places.push_back(object->transform.translation.x());
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places, (std::vector<double>{0, 7, 14, 21}));
  EXPECT_EQ(editor().history.position(), 3U);
  while (editor().history.can_undo()) editor().undo();
  EXPECT_EQ(editor().document(), before);
}

TEST_F(Arranging, ACopyThatIsTurnedInsteadIsOneStepToo) {
  move_active({5, 0, 0});
  bench_.move(600, 400);
  bench_.key("Shift+D");
  for (const char* key : {"R", "Z", "9", "0", "Enter"}) bench_.key(key);
  ASSERT_EQ(objects().size(), 2U);
  EXPECT_EQ(editor().history.position(), 2U);
  EXPECT_LT((objects()[1]->transform.rotation * Vector3::UnitX() - Vector3::UnitY()).norm(), 1e-12);
}

TEST_F(Arranging, EscTakesTheCopyAwayAgain) {
  run("add.box");
  const Document before = editor().document();
  const Selection chosen = editor().selection;
  const ElementMode mode = editor().mode;
  const std::size_t position = editor().history.position();
  bench_.move(600, 400);
  bench_.key("Shift+D");
  bench_.move(640, 380);
  bench_.key("X");
  EXPECT_EQ(objects().size(), 3U);
  bench_.key("Esc");
  EXPECT_FALSE(bench_.workbench().viewport().tool_active());
  EXPECT_EQ(editor().document(), before);
  EXPECT_EQ(editor().history.position(), position);
  EXPECT_TRUE(editor().selection == chosen);
  EXPECT_EQ(editor().mode, mode);
  // So does the right button, and turning instead of moving before that.
  bench_.key("Shift+D");
  bench_.key("R");
  bench_.move(700, 300);
  EXPECT_EQ(objects().size(), 3U);
  bench_.press(1);
  bench_.release(1);
  EXPECT_EQ(editor().document(), before);
}

TEST_F(Arranging, SidesOfWhatIsSeenAreAligned) {
  run("add.sphere");
  move_active({9, -4, 3});
  run("add.torus");
  move_active({-5, 8, 1});
  bench_.wait_for_surfaces();
  for (const auto& object : objects())
    editor().selection.select({object->id, element_of(object->id)}, Selection::How::add);
  const ObjectId fixed = objects()[1]->id;
  editor().selection.active = fixed;
  const auto box = [&](std::size_t i) { return shown_box(editor(), *objects()[i]); };
  const double place = box(1).min().x();
  run("object.align_x_low");
  bench_.wait_for_surfaces();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(box(i).min().x(), place, 1e-4);
  EXPECT_EQ(editor().history.undo_label(), "Align objects");
  run("object.align_y_centre");
  bench_.wait_for_surfaces();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(box(i).center().y(), box(1).center().y(), 1e-4);
  run("object.align_y_centre");
  EXPECT_EQ(editor().notices().back().text, "The objects lie like this already.");
}

TEST_F(Arranging, GapsOfWhatIsSeenAreMadeEqual) {
  run("object.array_row");
  enter("array_count", "4");
  enter("array_x", "6");
  for (const std::size_t i : {1U, 2U}) {
    editor().selection.active = objects()[i]->id;
    move_active({i == 1 ? 3.0 : 15.5, 0, 0});
  }
  bench_.wait_for_surfaces();
  for (const auto& object : objects())
    editor().selection.select({object->id, element_of(object->id)}, Selection::How::add);
  run("object.distribute_x");
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(place(i).x(), 6.0 * double(i), 1e-4);
}

TEST_F(Arranging, FewObjectsAreToldSo) {
  const auto& commands = bench_.workbench().commands();
  EXPECT_NE(commands.run("object.align_z_high").reason.find("two"), std::string::npos);
  EXPECT_NE(commands.run("object.distribute_z").reason.find("three"), std::string::npos);
}

TEST_F(Arranging, ARowIsRepeatedOnWhatIsChosenThen) {
  run("object.array_row");
  enter("array_x", "4");
  const ObjectId last = objects()[2]->id;
  editor().selection.clear_objects();
  editor().selection.select({last, element_of(last)}, Selection::How::add);
  bench_.key("Shift+R");
  ASSERT_EQ(objects().size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(place(i), Vector3(4.0 * double(i), 0, 0));
  EXPECT_EQ(editor().history.position(), 2U);
  enter("array_count", "2");
  EXPECT_EQ(objects().size(), 4U) << "the repeated step is adjusted, and not the first";
}

TEST_F(Arranging, ANewObjectIsAddedAgainUnderANameOfItsOwn) {
  run("add.box");
  bench_.key("Shift+R");
  ASSERT_EQ(objects().size(), 3U);
  EXPECT_EQ(objects()[1]->name, "Box 2");
  EXPECT_EQ(objects()[2]->name, "Box 3");
}

class Repeating : public Arranging {
 protected:
  void choose_face(unsigned face) {
    editor().mode = ElementMode::face;
    editor().selection.clear_elements();
    editor().selection.select({editor().selection.active, element_of(FaceId{face})}, Selection::How::add);
    bench_.frame();
  }
  const Polyhedron& polyhedron() { return editor().active_object()->polyhedron()->polyhedron; }
};

TEST_F(Repeating, AMoveIsMadeAgainOnWhatIsSelectedThen) {
  editor().mode = ElementMode::vertex;
  editor().selection.select({editor().selection.active, element_of(VertexId{0})}, Selection::How::replace);
  const Vector3 before = polyhedron().position(1);
  bench_.move(600, 400);
  for (const char* key : {"G", "Z", "3", "Enter"}) bench_.key(key);
  editor().selection.select({editor().selection.active, element_of(VertexId{1})}, Selection::How::replace);
  bench_.key("Shift+R");
  EXPECT_EQ(polyhedron().position(1), Vector3(before + Vector3(0, 0, 3)));
  EXPECT_EQ(editor().history.undo_label(), "Move vertex");
  EXPECT_TRUE(editor().selection.of_active().vertices.contains(VertexId{1})) << "the selection stays";
  EXPECT_EQ(editor().history.position(), 2U);
}

TEST_F(Repeating, AnAmountIsTakenAgain) {
  choose_face(0);
  bench_.move(600, 400);
  for (const char* key : {"E", "2", "Enter"}) bench_.key(key);
  const Index once = polyhedron().face_count();
  choose_face(1);
  bench_.key("Shift+R");
  EXPECT_GT(polyhedron().face_count(), once);
  EXPECT_EQ(editor().history.undo_label(), "Extrude face");
  const Box3 box = world_box(*editor().active_object());
  EXPECT_NEAR(box.sizes().z(), 2 + 2 + 2, 1e-9) << "bottom and top are moved out by the same length";
  EXPECT_EQ(editor().selection.of_active().faces.size(), 1U) << "as after extruding";
  editor().selection.clear_elements();
  bench_.key("Shift+R");
  ASSERT_FALSE(editor().notices().empty()) << "nothing is selected to extrude";
  EXPECT_EQ(editor().history.position(), 2U);
}

TEST_F(Repeating, ACommandWithoutNumbersIsRunAgain) {
  choose_face(0);
  run("mesh.poke");
  const Index once = polyhedron().face_count();
  choose_face(1);
  bench_.key("Shift+R");
  EXPECT_EQ(polyhedron().face_count(), once + 3);
}

TEST_F(Repeating, StepsThatCannotBeRepeatedAreNotMistakenForOthers) {
  const auto& commands = bench_.workbench().commands();
  EXPECT_FALSE(commands.run("edit.repeat").ran) << "nothing was done yet";
  choose_face(0);
  run("mesh.poke");
  editor().commit(rename_object(editor().history.current(), editor().selection.active, "Tower"), "Rename");
  EXPECT_FALSE(commands.run("edit.repeat").ran);
  editor().undo();
  choose_face(0);
  const auto outcome = commands.run("edit.repeat");
  EXPECT_TRUE(outcome.ran) << "it was taken back: " << outcome.reason;
}

}  // namespace
}  // namespace hariko::test

// Live copies by hand: an array that makes them, what is seen and picked of them, and objects made of them.

#include <imgui_internal.h>

#include "core/document/edits/edits.hpp"
#include "tests/workbench/program_hands.hpp"
#include "ui/editor/object_size.hpp"

namespace hariko::test {
namespace {

class LiveCopiesByHand : public ::testing::Test, protected ProgramHands {
 protected:
  const std::vector<std::shared_ptr<const Object>>& objects() { return editor().document().objects; }
  const Object& box() { return *objects().front(); }
  const Scene& scene() { return bench().workbench().viewport().scene().scene(); }
  void run_by_name(const char* words) {
    press({"F3"});
    type(words);
    press({"Enter"});
    wait();
  }
  void choose(const std::string& list, int number) {
    click("combo." + list);
    click("choice." + list + "." + std::to_string(number));
    wait();
  }
  /// A box with three places.
  void make_row() {
    click("menu.Add");
    click("command.add.box");
    wait();
    run_by_name("array in a row");
    choose("array_copies", 1);
  }
};

TEST_F(LiveCopiesByHand, OneObjectStandsAtManyPlaces) {
  make_row();
  ASSERT_EQ(objects().size(), 1U) << notice();
  EXPECT_EQ(place_count(box()), 3U);
  EXPECT_EQ(editor().history.position(), 2U) << "one step, whatever was adjusted";
  EXPECT_EQ(editor().history.undo_label(), "Array in a row");
  ASSERT_EQ(scene().objects.size(), 3U);
  for (const SceneObject& shown : scene().objects) EXPECT_EQ(shown.mesh, scene().objects[0].mesh);
  EXPECT_FALSE(scene().objects[0].copy);
  EXPECT_TRUE(scene().objects[2].copy);
  // The whole row counts where the size of what is shown does.
  EXPECT_GT(shown_box(editor(), box()).sizes().x(), 2 * own_box(editor(), box()).sizes().x());
  const Projector projector(editor().camera(), editor().viewport);
  for (const Similarity& place : places_of(box())) {
    const auto at = projector.project(place.apply(own_box(editor(), box()).center()));
    ASSERT_TRUE(at);
    EXPECT_TRUE(at->x() >= 0 && at->x() <= editor().viewport.width) << "copies come into sight";
  }
  press({"Ctrl+Z"});
  EXPECT_EQ(place_count(box()), 1U);
  press({"Ctrl+Shift+Z"});
  EXPECT_EQ(place_count(box()), 3U);
}

TEST_F(LiveCopiesByHand, ACopyIsPickedAsItsObject) {
  make_row();
  const Vector3 middle = own_box(editor(), box()).center();
  const Vector3 last = places_of(box())[2].apply(middle), own = places_of(box())[0].apply(middle);
  press({"4"});
  editor().selection.clear_objects();
  frames(2);
  click(pixel(last));
  EXPECT_TRUE(editor().selection.objects().contains(box().id));
  // Elements are those at the own place.
  press({"3"});
  editor().selection.clear_elements();
  frames(2);
  click(pixel(last));
  EXPECT_TRUE(editor().selection.of(box().id).empty());
  click(pixel(own));
  EXPECT_FALSE(editor().selection.of(box().id).empty());
}

TEST_F(LiveCopiesByHand, ARowOfARowIsAGrid) {
  make_row();
  run_by_name("array in a row");
  choose("array_copies", 1);
  EXPECT_EQ(objects().size(), 1U);
  EXPECT_EQ(place_count(box()), 9U);
}

TEST_F(LiveCopiesByHand, TheirNumbersCanBeChangedLater) {
  make_row();
  press({"4"});
  click(pixel(places_of(box())[0].apply(own_box(editor(), box()).center())));
  ASSERT_TRUE(marks().contains("field.copies_count"));
  click("field.copies_count");
  type("7");
  press({"Enter"});
  wait();
  EXPECT_EQ(place_count(box()), 7U);
  EXPECT_EQ(editor().history.undo_label(), "Live copies");
}

TEST_F(LiveCopiesByHand, OneCanBeTheMirrorImage) {
  click("menu.Add");
  click("command.add.box");
  wait();
  run_by_name("mirrored copy across x");
  click("field.mirror_position");
  type("130");
  press({"Enter"});
  wait();
  choose("array_copies", 1);
  ASSERT_EQ(objects().size(), 1U) << notice();
  ASSERT_EQ(place_count(box()), 2U);
  EXPECT_EQ(editor().history.position(), 2U) << "one step, whatever was adjusted";
  EXPECT_EQ(editor().history.undo_label(), "Mirrored copy");
  const Similarity own = places_of(box())[0], image = places_of(box())[1];
  EXPECT_TRUE(image.mirrors());
  EXPECT_NEAR(image.translation.x(), 260 - own.translation.x(), 1e-6);
  ASSERT_EQ(scene().objects.size(), 2U);
  EXPECT_EQ(scene().objects[1].mesh, scene().objects[0].mesh);
  EXPECT_LT((scene().objects[1].transform.topLeftCorner<3, 3>().determinant()), 0);
  // It is picked as its object.
  ASSERT_TRUE(bench().workbench().commands().run("view.frame_all").ran);
  frames(20);
  press({"4"});
  editor().selection.clear_objects();
  frames(2);
  click(pixel(image.apply(own_box(editor(), box()).center())));
  EXPECT_TRUE(editor().selection.objects().contains(box().id));
  // Its plane can be moved later.
  ASSERT_TRUE(marks().contains("field.copies_plane"));
  click("field.copies_plane");
  type("200");
  press({"Enter"});
  wait();
  EXPECT_NEAR(places_of(box())[1].translation.x(), 400 + own.translation.x(), 1e-6);
  EXPECT_EQ(editor().history.undo_label(), "Live copies");
  press({"Ctrl+Z", "Ctrl+Z"});
  EXPECT_EQ(place_count(box()), 1U);
}

TEST_F(LiveCopiesByHand, TheListTellsTheirNumber) {
  make_row();
  const std::string mark = "copies." + std::to_string(box().id.value);
  ASSERT_TRUE(marks().contains(mark));
  const Vector2 at = middle_of(mark);
  bench().move(at.x(), at.y());
  frames(4);
  int tips = 0;
  for (const ImGuiWindow* tip : GImGui->Windows)
    tips += (tip->Flags & ImGuiWindowFlags_Tooltip) != 0 && tip->WasActive && !tip->Hidden ? 1 : 0;
  EXPECT_EQ(tips, 1);
  run_by_name("remove live copies");
  EXPECT_FALSE(marks().contains(mark));
}

TEST_F(LiveCopiesByHand, TheyBecomeObjectsOrGoAway) {
  make_row();
  const auto places = places_of(box());
  run_by_name("make copies objects");
  ASSERT_EQ(objects().size(), 3U) << notice();
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(objects()[k]->copies->empty());
    EXPECT_LT((objects()[k]->transform.translation - places[k].translation).norm(), 1e-9);
  }
  EXPECT_EQ(editor().selection.objects().size(), 3U);
  EXPECT_FALSE(bench().workbench().commands().run("object.copies_to_objects").ran) << "there are none left";
  press({"Ctrl+Z"});
  ASSERT_EQ(objects().size(), 1U);
  EXPECT_EQ(place_count(box()), 3U);
  editor().selection.select({box().id, element_of(box().id)}, Selection::How::replace);
  run_by_name("remove live copies");
  EXPECT_EQ(place_count(box()), 1U);
  EXPECT_EQ(scene().objects.size(), 1U);
}

}  // namespace
}  // namespace hariko::test

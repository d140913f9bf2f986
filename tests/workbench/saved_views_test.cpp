// Saved views and the lens by hand: the menu beside a view's title, the palette, keys, undo, and a 3D mouse.

#include <gtest/gtest.h>

#include <cmath>

#include "core/document/edits/edits.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"
#include "ui/editor/saved_views.hpp"

namespace hariko {
namespace {

class ViewHands : public ::testing::Test {
 protected:
  ViewHands() : bench(document_from_mesh(test::cube(), "Cube").value(), {1280, 900}) {
    bench.wait_for_surfaces();
    frames(6);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) bench.frame();
  }
  const std::map<std::string, Marks::Rect>& marks() { return bench.workbench().marks().all(); }
  void open_menu() {
    if (!marks().contains("views.view.save")) bench.click("view.0.views");
    frames(2);
    ASSERT_TRUE(marks().contains("views.view.save"));
  }
  void choose(const std::string& row) {
    open_menu();
    ASSERT_TRUE(marks().contains(row)) << row;
    bench.click(row);
    frames(8);  // flights end
  }
  void close_menu() {
    bench.key("Esc");
    frames(2);
    bench.move(640, 500);
  }
  void orbit() {
    bench.move(640, 500);
    bench.press(2);
    bench.move(720, 470);
    bench.release(2);
    frames(2);
  }
  void palette_to(const char* words, const std::string& selected) {
    bench.tap("F3");
    frames(3);
    bench.type(words);
    frames(2);
    ASSERT_TRUE(marks().contains("palette.selected." + selected)) << words;
    bench.tap("Enter");
    frames(8);
  }
  const SavedViews& views() { return *editor.document().saved_views; }
  Camera camera() { return editor.layout.active_view().goal(); }
  double focal() { return focal_length_of(camera().field_of_view); }

  test::HeadlessWorkbench bench;
  Editor& editor = bench.editor();
};

TEST_F(ViewHands, AViewIsSavedGoneToUpdatedAndDeletedInTheMenu) {
  const Camera first = camera();
  choose("views.view.save");
  ASSERT_EQ(views().size(), 1U);
  EXPECT_EQ(views()[0].name, "View 1");
  EXPECT_TRUE(looks_as(first, views()[0]));
  close_menu();
  orbit();
  EXPECT_FALSE(looks_as(camera(), views()[0]));
  choose("views.go.View 1");
  EXPECT_TRUE(looks_as(camera(), views()[0]));
  close_menu();
  orbit();
  const Camera turned = camera();
  choose("views.update.View 1");
  EXPECT_TRUE(looks_as(turned, views()[0]));
  choose("views.delete.View 1");
  EXPECT_TRUE(views().empty());
  close_menu();
  // Each was one step.
  bench.key("Ctrl+Z");
  ASSERT_EQ(views().size(), 1U);
  EXPECT_TRUE(looks_as(turned, views()[0]));
  bench.key("Ctrl+Z");
  EXPECT_TRUE(looks_as(first, views()[0]));
  bench.key("Ctrl+Z");
  EXPECT_TRUE(views().empty());
}

TEST_F(ViewHands, ThePaletteFindsSavedViewsByName) {
  bench.key("Ctrl+Alt+V");
  ASSERT_EQ(views().size(), 1U);
  ASSERT_TRUE(name_view(editor, "View 1", "Zephyr"));
  const Camera saved = camera();
  orbit();
  palette_to("zephyr", "view:Zephyr");
  EXPECT_TRUE(looks_as(saved, views()[0]));
  EXPECT_TRUE(looks_as(camera(), views()[0]));
  // Previous view leads back.
  bench.workbench().commands().run("view.previous");
  frames(8);
  EXPECT_FALSE(looks_as(camera(), views()[0]));
}

TEST_F(ViewHands, AViewGetsAnotherNameByAQuestion) {
  bench.key("Ctrl+Alt+V");
  choose("views.rename.View 1");
  frames(4);
  ASSERT_TRUE(bench.workbench().question() != nullptr);
  bench.type("Left");  // all of the old name is selected
  bench.click("prompt.rename");
  frames(3);
  ASSERT_EQ(views().size(), 1U);
  EXPECT_EQ(views()[0].name, "Left");
  EXPECT_EQ(editor.saved_view, "Left");
}

TEST_F(ViewHands, KeysGoFromOneSavedViewToTheNext) {
  bench.key("Ctrl+Alt+V");
  orbit();
  bench.key("Ctrl+Alt+V");
  bench.key("Num 7");
  frames(8);
  bench.key("Ctrl+Alt+V");
  ASSERT_EQ(views().size(), 3U);
  for (const int expected : {0, 1, 2, 0}) {
    bench.key("Alt+PgDn");
    frames(8);
    EXPECT_TRUE(looks_as(camera(), views()[std::size_t(expected)])) << expected;
  }
  bench.key("Alt+PgUp");
  frames(8);
  EXPECT_TRUE(looks_as(camera(), views()[2]));
  EXPECT_TRUE(camera().orthographic) << "a view from a side is saved as it was";
}

TEST_F(ViewHands, ANewViewIsNamedInTheLanguageOfTheInterface) {
  bench.key("Ctrl+Alt+V");
  editor.language = Language::load(test::source_folder() + "/assets/languages/ja.json").value();
  for (int i = 0; i < 2; ++i) bench.key("Ctrl+Alt+V");
  ASSERT_EQ(views().size(), 3U);
  EXPECT_EQ(views()[0].name, "View 1") << "a name is the designer's once it is given";
  EXPECT_EQ(views()[1].name, "\u30d3\u30e5\u30fc 1");
  EXPECT_EQ(views()[2].name, "\u30d3\u30e5\u30fc 2");
}

TEST_F(ViewHands, AViewThatIsGoneAfterUndoIsNotChosen) {
  const auto why = [&] { return bench.workbench().commands().find("view.update")->why_not(); };
  EXPECT_TRUE(why());
  bench.key("Ctrl+Alt+V");
  EXPECT_FALSE(why());
  bench.key("Ctrl+Z");
  EXPECT_TRUE(why());
}

TEST_F(ViewHands, TheLensIsDraggedAndSteppedAndKeepsTheSizeOfTheModel) {
  const double height = camera().view_height();
  open_menu();
  const Marks::Rect field = marks().at("views.focal_length");
  bench.move(field.x + 0.2 * field.width, field.y + field.height / 2.0);
  bench.press();
  bench.move(field.x + 0.9 * field.width, field.y + field.height / 2.0);
  bench.release();
  frames(2);
  EXPECT_GT(focal(), 100);
  EXPECT_LE(focal(), 300 + 1e-3);
  EXPECT_NEAR(camera().view_height(), height, 1e-6 * height);
  close_menu();
  editor.layout.active_view().go_back(editor.now);  // one step for the whole drag
  frames(8);
  EXPECT_NEAR(focal(), 47, 0.5);
  bench.key("Alt+Num +");
  frames(8);
  EXPECT_NEAR(focal(), 50, 1e-6);
  bench.key("Alt+Num -");
  frames(8);
  EXPECT_NEAR(focal(), 35, 1e-6);
  for (int i = 0; i < 10; ++i) bench.key("Alt+Num -"), frames(8);
  EXPECT_NEAR(focal(), 15, 1e-6);
  EXPECT_NEAR(camera().view_height(), height, 1e-6 * height);
}

TEST_F(ViewHands, TwoPointPerspectiveKeepsVerticalsUprightAndIsSaved) {
  const auto lean_of_edge = [&] {
    const Projector projector(editor.camera(), editor.viewport);
    const auto low = projector.project({1, 1, -1}), high = projector.project({1, 1, 1});
    return std::abs(low->x() - high->x());
  };
  EXPECT_GT(lean_of_edge(), 1);
  bench.key("Ctrl+Num 5");
  frames(4);
  EXPECT_LT(lean_of_edge(), 1e-6);
  bench.key("Ctrl+Alt+V");
  EXPECT_EQ(views()[0].projection, Projection::two_point);
  choose("views.view.two_point");
  EXPECT_GT(lean_of_edge(), 1);
  // From a parallel view it is perspective at once.
  bench.key("Num 5");
  EXPECT_TRUE(camera().orthographic);
  bench.key("Ctrl+Num 5");
  EXPECT_FALSE(camera().orthographic);
  EXPECT_TRUE(camera().two_point);
}

TEST_F(ViewHands, ElementsAreClickedWhereTwoPointPerspectiveShowsThem) {
  bench.key("Ctrl+Num 5");
  bench.key("1");
  frames(4);
  const Object& cube = *editor.document().objects.front();
  const Polyhedron& cage = *cube.cage();
  const Projector projector(editor.camera(), editor.viewport);
  // The corner that is nearest to the eye hides behind nothing.
  Index nearest = 0;
  double least = 1e300;
  for (Index v = 0; v < cage.vertex_count(); ++v) {
    const Vector3 at = cube.transform.apply(cube.cage_origin() + cage.positions()[v]);
    const double distance = (at - editor.camera().eye()).norm();
    if (distance < least) nearest = v, least = distance;
  }
  const Vector3 at = cube.transform.apply(cube.cage_origin() + cage.positions()[nearest]);
  const Vector3 pixel = *projector.project(at);
  const ImVec2 corner = bench.workbench().viewport().rect().min;
  bench.move(pixel.x() + double(corner.x), pixel.y() + double(corner.y));
  frames(2);
  ASSERT_TRUE(editor.hovered);
  EXPECT_EQ(editor.hovered->element, element_of(cage.vertex_id(nearest)));
}

TEST_F(ViewHands, ScriptsSaveRenameAndDeleteByName) {
  const CommandTable& commands = bench.workbench().commands();
  const auto run = [&](const char* id, const std::vector<WrittenArgument>& given) {
    const Command& command = *commands.find(id);
    const auto read = read_arguments(command.script.arguments, given, editor.document().unit);
    ASSERT_TRUE(read) << to_string(read.error());
    const auto outcome = commands.run_in_script(command, *read);
    EXPECT_TRUE(outcome.ran) << id << ": " << outcome.reason;
  };
  run("view.save", {written("name", std::string("Front")), written("from", std::string("front")),
                    written("focal_length", 85)});
  ASSERT_EQ(views().size(), 1U);
  EXPECT_EQ(side_of(camera_of(views()[0])), StandardView::front);
  EXPECT_NEAR(views()[0].focal_length, 85, 1e-12);
  const auto middle = Projector(camera_of(views()[0]), {900, 600}).project({0, 0, 0});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x(), 450, 1) << "everything is framed";
  run("view.save", {written("name", std::string("Near")), written("distance", 5.0)});
  EXPECT_EQ(views()[1].distance, 5);
  run("view.rename", {written("name", std::string("Front")), written("to", std::string("Side"))});
  EXPECT_EQ(views()[0].name, "Side");
  run("view.delete", {written("name", std::string("Side"))});
  ASSERT_EQ(views().size(), 1U);
  EXPECT_EQ(views()[0].name, "Near");
}

TEST_F(ViewHands, TheCapOfA3DMouseMovesTheViewAndItsButtonsFrameAndSearch) {
  const Camera before = camera();
  bench.workbench().cap({Vector3(1, 0, 0), Vector3(0, 0.5, 0), 0.02});
  frames(2);
  EXPECT_FALSE(camera() == before);
  EXPECT_EQ(editor.history.position(), 0U) << "the document stays";
  for (int i = 0; i < 100; ++i) bench.workbench().cap({Vector3(1, 0, 0), Vector3::Zero(), 0.05});
  bench.workbench().cap_button(1);
  frames(8);
  const auto middle = Projector(editor.camera(), editor.viewport).project({0, 0, 0});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x(), editor.viewport.width / 2.0, 0.1 * editor.viewport.width);
  bench.workbench().cap_button(0);
  frames(3);
  EXPECT_TRUE(marks().contains("palette.input"));
  const Camera still = camera();
  bench.workbench().cap({Vector3(1, 0, 0), Vector3::Zero(), 0.05});
  EXPECT_TRUE(camera() == still) << "while the palette is open";
  bench.workbench().cap_button(9);
}

}  // namespace
}  // namespace hariko

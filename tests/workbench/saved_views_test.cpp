// Saved views and the lens by hand: the menu beside a view's title, the palette, keys, undo, and a 3D mouse.

#include <cmath>

#include "tests/support/places.hpp"
#include "tests/workbench/bench_hands.hpp"
#include "ui/editor/saved_views.hpp"

namespace hariko {
namespace {

class ViewHands : public test::BenchHands {
 protected:
  ViewHands() : BenchHands(document_from_mesh(test::cube(), "Cube").value(), {1280, 900}) {
    bench_.wait_for_surfaces();
    frames(6);
  }
  void open_menu() {
    if (!marks().contains("views.view.save")) bench_.click("view.0.views");
    frames(2);
    ASSERT_TRUE(marks().contains("views.view.save"));
  }
  void choose(const std::string& row) {
    open_menu();
    bench_.click(row);
    frames(8);  // flights end
  }
  void close_menu() {
    bench_.key("Esc");
    frames(2);
    bench_.move(640, 500);
  }
  void orbit() {
    bench_.move(640, 500);
    bench_.press(2);
    bench_.move(720, 470);
    bench_.release(2);
    frames(2);
  }
  void palette_to(const char* words, const std::string& selected) {
    bench_.tap("F3");
    frames(3);
    bench_.type(words);
    frames(2);
    ASSERT_TRUE(marks().contains("palette.selected." + selected)) << words;
    bench_.tap("Enter");
    frames(8);
  }
  const SavedViews& views() { return *editor().document().saved_views; }
  Camera camera() { return editor().layout.active_view().goal(); }
  double focal() { return focal_length_of(camera().field_of_view); }
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
  bench_.key("Ctrl+Z");
  ASSERT_EQ(views().size(), 1U);
  EXPECT_TRUE(looks_as(turned, views()[0]));
  bench_.key("Ctrl+Z");
  EXPECT_TRUE(looks_as(first, views()[0]));
  bench_.key("Ctrl+Z");
  EXPECT_TRUE(views().empty());
}

TEST_F(ViewHands, ThePaletteFindsSavedViewsByName) {
  bench_.key("Ctrl+Alt+V");
  ASSERT_EQ(views().size(), 1U);
  ASSERT_TRUE(name_view(editor(), "View 1", "Zephyr"));
  const Camera saved = camera();
  orbit();
  palette_to("zephyr", "view:Zephyr");
  EXPECT_TRUE(looks_as(saved, views()[0]));
  EXPECT_TRUE(looks_as(camera(), views()[0]));
  // Previous view leads back.
  bench_.workbench().commands().run("view.previous");
  frames(8);
  EXPECT_FALSE(looks_as(camera(), views()[0]));
}

TEST_F(ViewHands, AViewGetsAnotherNameByAQuestion) {
  bench_.key("Ctrl+Alt+V");
  choose("views.rename.View 1");
  frames(4);
  ASSERT_TRUE(bench_.workbench().question() != nullptr);
  bench_.type("Left");  // all of the old name is selected
  bench_.click("prompt.rename");
  frames(3);
  ASSERT_EQ(views().size(), 1U);
  EXPECT_EQ(views()[0].name, "Left");
  EXPECT_EQ(editor().saved_view, "Left");
}

TEST_F(ViewHands, KeysGoFromOneSavedViewToTheNext) {
  bench_.key("Ctrl+Alt+V");
  orbit();
  bench_.key("Ctrl+Alt+V");
  bench_.key("Num 7");
  frames(8);
  bench_.key("Ctrl+Alt+V");
  ASSERT_EQ(views().size(), 3U);
  for (const int expected : {0, 1, 2, 0}) {
    bench_.key("Alt+PgDn");
    frames(8);
    EXPECT_TRUE(looks_as(camera(), views()[std::size_t(expected)])) << expected;
  }
  bench_.key("Alt+PgUp");
  frames(8);
  EXPECT_TRUE(looks_as(camera(), views()[2]));
  EXPECT_TRUE(camera().orthographic) << "a view from a side is saved as it was";
}

TEST_F(ViewHands, ANewViewIsNamedInTheLanguageOfTheInterface) {
  bench_.key("Ctrl+Alt+V");
  editor().language = Language::load(test::source_folder() + "/assets/languages/ja.po").value();
  for (int i = 0; i < 2; ++i) bench_.key("Ctrl+Alt+V");
  ASSERT_EQ(views().size(), 3U);
  EXPECT_EQ(views()[0].name, "View 1") << "a name is the designer's once it is given";
  EXPECT_EQ(views()[1].name, "\u30d3\u30e5\u30fc 1");
  EXPECT_EQ(views()[2].name, "\u30d3\u30e5\u30fc 2");
}

TEST_F(ViewHands, AViewThatIsGoneAfterUndoIsNotChosen) {
  const auto why = [&] { return bench_.workbench().commands().find("view.update")->why_not(); };
  EXPECT_TRUE(why());
  bench_.key("Ctrl+Alt+V");
  EXPECT_FALSE(why());
  bench_.key("Ctrl+Z");
  EXPECT_TRUE(why());
}

TEST_F(ViewHands, TheLensIsDraggedAndSteppedAndKeepsTheSizeOfTheModel) {
  const double height = camera().view_height();
  open_menu();
  const Marks::Rect field = marks().at("views.focal_length");
  bench_.move(field.x + 0.2 * field.width, field.y + field.height / 2.0);
  bench_.press();
  bench_.move(field.x + 0.9 * field.width, field.y + field.height / 2.0);
  bench_.release();
  frames(2);
  EXPECT_GT(focal(), 100);
  EXPECT_LE(focal(), 300 + 1e-3);
  EXPECT_NEAR(camera().view_height(), height, 1e-6 * height);
  close_menu();
  editor().layout.active_view().go_back(editor().now);  // one step for the whole drag
  frames(8);
  EXPECT_NEAR(focal(), 47, 0.5);
  bench_.key("Alt+Num +");
  frames(8);
  EXPECT_NEAR(focal(), 50, 1e-6);
  bench_.key("Alt+Num -");
  frames(8);
  EXPECT_NEAR(focal(), 35, 1e-6);
  for (int i = 0; i < 10; ++i) bench_.key("Alt+Num -"), frames(8);
  EXPECT_NEAR(focal(), 15, 1e-6);
  EXPECT_NEAR(camera().view_height(), height, 1e-6 * height);
}

TEST_F(ViewHands, TwoPointPerspectiveKeepsVerticalsUprightAndIsSaved) {
  const auto lean_of_edge = [&] {
    const Projector projector(editor().camera(), editor().viewport);
    const auto low = projector.project({1, 1, -1}), high = projector.project({1, 1, 1});
    return std::abs(low->x() - high->x());
  };
  EXPECT_GT(lean_of_edge(), 1);
  bench_.key("Ctrl+Num 5");
  frames(4);
  EXPECT_LT(lean_of_edge(), 1e-6);
  bench_.key("Ctrl+Alt+V");
  EXPECT_EQ(views()[0].projection, Projection::two_point);
  choose("views.view.two_point");
  EXPECT_GT(lean_of_edge(), 1);
  // From a parallel view it is perspective at once.
  bench_.key("Num 5");
  EXPECT_TRUE(camera().orthographic);
  bench_.key("Ctrl+Num 5");
  EXPECT_FALSE(camera().orthographic);
  EXPECT_TRUE(camera().two_point);
}

TEST_F(ViewHands, ElementsAreClickedWhereTwoPointPerspectiveShowsThem) {
  bench_.key("Ctrl+Num 5");
  bench_.key("1");
  frames(4);
  const Object& cube = *editor().document().objects.front();
  const Polyhedron& cage = *cube.cage();
  const Projector projector(editor().camera(), editor().viewport);
  // The corner that is nearest to the eye hides behind nothing.
  Index nearest = 0;
  double least = 1e300;
  for (Index v = 0; v < cage.vertex_count(); ++v) {
    const Vector3 at = cube.transform.apply(cube.cage_origin() + cage.positions()[v]);
    const double distance = (at - editor().camera().eye()).norm();
    if (distance < least) nearest = v, least = distance;
  }
  const Vector3 at = cube.transform.apply(cube.cage_origin() + cage.positions()[nearest]);
  const Vector3 pixel = *projector.project(at);
  const ImVec2 corner = bench_.workbench().viewport().rect().min;
  bench_.move(pixel.x() + double(corner.x), pixel.y() + double(corner.y));
  frames(2);
  ASSERT_TRUE(editor().hovered);
  EXPECT_EQ(editor().hovered->element, element_of(cage.vertex_id(nearest)));
}

TEST_F(ViewHands, ScriptsSaveRenameAndDeleteByName) {
  const CommandTable& commands = bench_.workbench().commands();
  const auto run = [&](const char* id, const std::vector<WrittenArgument>& given) {
    const Command& command = *commands.find(id);
    const auto read = test::must(read_arguments(command.script.arguments, given, editor().document().unit));
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
  bench_.workbench().cap({Vector3(1, 0, 0), Vector3(0, 0.5, 0), 0.02});
  frames(2);
  EXPECT_FALSE(camera() == before);
  EXPECT_EQ(editor().history.position(), 0U) << "the document stays";
  for (int i = 0; i < 100; ++i) bench_.workbench().cap({Vector3(1, 0, 0), Vector3::Zero(), 0.05});
  bench_.workbench().cap_button(1);
  frames(8);
  const auto middle = Projector(editor().camera(), editor().viewport).project({0, 0, 0});
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->x(), editor().viewport.width / 2.0, 0.1 * editor().viewport.width);
  bench_.workbench().cap_button(0);
  frames(3);
  EXPECT_TRUE(marks().contains("palette.input"));
  const Camera still = camera();
  bench_.workbench().cap({Vector3(1, 0, 0), Vector3::Zero(), 0.05});
  EXPECT_TRUE(camera() == still) << "while the palette is open";
  bench_.workbench().cap_button(9);
}

}  // namespace
}  // namespace hariko

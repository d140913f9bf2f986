// Fields that open under a click: what is typed at once goes into them and is no command.

#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko::test {
namespace {

Vector2 centre_of(const Marks::Rect& rect) {
  return {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
}

TEST(Fields, DigitsRightAfterAClickOnTheLegendAreItsNumber) {
  HeadlessWorkbench bench(document_from_mesh(test::prism(4), "Box").value());
  Editor& editor = bench.editor();
  DisplaySettings display = editor.active_object()->display;
  display.map = SurfaceMap::mean;
  editor.commit(set_display(editor.document(), editor.active_object()->id, display), "Map");
  const auto& marks = bench.workbench().marks().all();
  for (int i = 0; i < 20 && !marks.contains("legend.high"); ++i) bench.settle();
  ASSERT_TRUE(marks.contains("legend.high"));
  const auto click = [&](const std::string& mark) {
    const Vector2 at = centre_of(marks.at(mark));
    bench.move(at.x(), at.y());
    bench.press();
    bench.release();
  };
  editor.mode = ElementMode::vertex;
  const std::size_t steps = editor.history.position();
  click("legend.high");
  // Keys that come before the field has the keyboard: the window holds them back meanwhile.
  for (int i = 0; i < 6 && bench.workbench().field_opening(); ++i) {
    bench.key("3");
    EXPECT_EQ(editor.mode, ElementMode::vertex) << "frame " << i;
  }
  EXPECT_FALSE(bench.workbench().field_opening()) << "it opened";
  // The very next key after the frame in which it did.
  bench.key("2");
  EXPECT_EQ(editor.mode, ElementMode::vertex);
  ImGui::GetIO().AddInputCharacter('7');
  bench.frame();
  click("viewport");
  bench.frame();
  EXPECT_EQ(range_of(editor.active_object()->display, SurfaceMap::mean).high, 7);
  EXPECT_EQ(editor.history.position(), steps + 1);
  bench.key("2");
  EXPECT_EQ(editor.mode, ElementMode::edge) << "the keys are commands again";
}

TEST(Fields, LettersRightAfterRenameAreNoCommands) {
  HeadlessWorkbench bench(document_from_mesh(test::prism(4), "Box").value());
  bench.editor().mode = ElementMode::vertex;
  bench.workbench().commands().run("object.rename");
  for (int i = 0; i < 8 && bench.workbench().field_opening(); ++i) {
    bench.key("3");
    EXPECT_EQ(bench.editor().mode, ElementMode::vertex) << "frame " << i;
  }
  EXPECT_FALSE(bench.workbench().field_opening());
  bench.key("3");
  EXPECT_EQ(bench.editor().mode, ElementMode::vertex);
}

TEST(Fields, AQuestionIsNamedWhereItIsClicked) {
  HeadlessWorkbench bench(document_from_mesh(test::prism(4), "Box").value());
  Editor& editor = bench.editor();
  bench.workbench().commands().run("object.duplicate");
  ASSERT_TRUE(editor.history.dirty());
  bench.workbench().commands().run("file.close");
  const auto& marks = bench.workbench().marks().all();
  for (int i = 0; i < 10 && !marks.contains("prompt.cancel"); ++i) bench.frame();
  ASSERT_TRUE(marks.contains("prompt.cancel"));
  const Marks::Rect first = marks.at("prompt.cancel");
  for (int i = 0; i < 3; ++i) bench.frame();
  EXPECT_EQ(marks.at("prompt.cancel"), first) << "its first place is its place";
  bench.move(centre_of(first).x(), centre_of(first).y());
  bench.press();
  bench.release();
  bench.frame();
  EXPECT_FALSE(marks.contains("prompt.cancel"));
  EXPECT_TRUE(editor.has_document);
}

}  // namespace
}  // namespace hariko::test

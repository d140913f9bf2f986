// What becomes of a tool when the document changes under it, as by a click into the list of steps.

#include <gtest/gtest.h>

#include "core/document/edits/edits.hpp"
#include "tests/support/random_polyhedra.hpp"
#include "tests/workbench/headless_workbench.hpp"

namespace hariko {
namespace {

class ToolsAndHistory : public ::testing::Test {
 protected:
  /// A box whose faces were split, with all that this made selected.
  ToolsAndHistory() {
    editor.mode = ElementMode::face;
    run("select.all");
    run("mesh.subdivide");
    editor.mode = ElementMode::vertex;
    run("select.all");
  }
  void run(const char* id) {
    EXPECT_TRUE(bench.workbench().commands().run(id).ran) << id;
    bench.frame();
  }
  bool selection_exists() const {
    Selection there = editor.selection;
    there.prune(editor.history.current());
    return there == editor.selection;
  }

  test::HeadlessWorkbench bench{document_from_mesh(test::prism(4), "Box").value()};
  Editor& editor = bench.editor();
};

TEST_F(ToolsAndHistory, ABoxThatIsGivenUpPutsNothingBackThatIsNoMore) {
  ASSERT_GT(editor.selection.of_active().vertices.size(), 8U);
  for (const bool wait : {false, true}) {
    run("select.box");
    ASSERT_TRUE(bench.workbench().viewport().tool_active());
    editor.go_to_step(0);
    if (wait) bench.frame();
    bench.key("Esc");
    EXPECT_FALSE(bench.workbench().viewport().tool_active());
    EXPECT_TRUE(selection_exists());
    editor.go_to_step(1);
    run("select.all");
  }
}

TEST_F(ToolsAndHistory, AMoveEndsWithTheDocumentItFound) {
  bench.key("G");
  for (const char* key : {"X", "2"}) bench.key(key);
  ASSERT_TRUE(editor.history.in_gesture());
  editor.go_to_step(0);
  const Document before = editor.history.current();
  bench.frame();
  EXPECT_FALSE(bench.workbench().viewport().tool_active());
  EXPECT_FALSE(editor.history.in_gesture());
  bench.key("Enter");
  EXPECT_EQ(editor.history.current(), before);
  EXPECT_TRUE(selection_exists());
}

TEST_F(ToolsAndHistory, APressThatIsReleasedLaterSelectsNothingThatIsNoMore) {
  // A click into the middle of an edge of the box, where its split put a vertex.
  const Document split = editor.document();
  const Polyhedron& cage = split.objects[0]->polyhedron()->polyhedron;
  const Vector3 origin = split.objects[0]->cage_origin();
  for (Index v = 8; v < cage.vertex_count(); ++v) {
    editor.go_to_step(1);
    bench.frame();
    const Projector projector(editor.camera(), editor.viewport);
    const auto at = projector.project(origin + cage.position(v));
    ASSERT_TRUE(at);
    const ImVec2 corner = bench.workbench().viewport().rect().min;
    bench.move(double(corner.x) + at->x(), double(corner.y) + at->y());
    bench.press();
    editor.go_to_step(0);
    bench.release();
    bench.frame();
    EXPECT_TRUE(selection_exists()) << "vertex " << v;
  }
}

}  // namespace
}  // namespace hariko

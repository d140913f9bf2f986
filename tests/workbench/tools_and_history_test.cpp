// Tools while the document changes under them, as by a click into the list of steps.

#include "tests/workbench/bench_hands.hpp"

namespace hariko {
namespace {

class ToolsAndHistory : public test::BenchHands {
 protected:
  /// A box whose faces were split, with all that this made selected.
  ToolsAndHistory() : BenchHands(test::box(), {800, 560}) {
    editor().mode = ElementMode::face;
    run("select.all");
    run("mesh.subdivide");
    editor().mode = ElementMode::vertex;
    run("select.all");
  }
  bool selection_exists() {
    Selection there = editor().selection;
    there.prune(editor().history.current());
    return there == editor().selection;
  }
};

TEST_F(ToolsAndHistory, ABoxThatIsGivenUpPutsNothingBackThatIsNoMore) {
  ASSERT_GT(editor().selection.of_active().vertices.size(), 8U);
  for (const bool wait : {false, true}) {
    run("select.box");
    ASSERT_TRUE(bench_.workbench().viewport().tool_active());
    editor().go_to_step(0);
    if (wait) bench_.frame();
    bench_.key("Esc");
    EXPECT_FALSE(bench_.workbench().viewport().tool_active());
    EXPECT_TRUE(selection_exists());
    editor().go_to_step(1);
    run("select.all");
  }
}

TEST_F(ToolsAndHistory, AMoveEndsWithTheDocumentItFound) {
  bench_.key("G");
  for (const char* key : {"X", "2"}) bench_.key(key);
  ASSERT_TRUE(editor().history.in_gesture());
  editor().go_to_step(0);
  const Document before = editor().history.current();
  bench_.frame();
  EXPECT_FALSE(bench_.workbench().viewport().tool_active());
  EXPECT_FALSE(editor().history.in_gesture());
  bench_.key("Enter");
  EXPECT_EQ(editor().history.current(), before);
  EXPECT_TRUE(selection_exists());
}

TEST_F(ToolsAndHistory, APressThatIsReleasedLaterSelectsNothingThatIsNoMore) {
  // A click into the middle of an edge of the box, where its split put a vertex.
  const Document split = editor().document();
  const Polyhedron& cage = split.objects[0]->polyhedron()->polyhedron;
  const Vector3 origin = split.objects[0]->cage_origin();
  for (Index v = 8; v < cage.vertex_count(); ++v) {
    editor().go_to_step(1);
    bench_.frame();
    const Projector projector(editor().camera(), editor().viewport);
    const auto at = projector.project(origin + cage.position(v));
    ASSERT_TRUE(at);
    const ImVec2 corner = bench_.workbench().viewport().rect().min;
    bench_.move(double(corner.x) + at->x(), double(corner.y) + at->y());
    bench_.press();
    editor().go_to_step(0);
    bench_.release();
    bench_.frame();
    EXPECT_TRUE(selection_exists()) << "vertex " << v;
  }
}

}  // namespace
}  // namespace hariko

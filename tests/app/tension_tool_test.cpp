// The tension tool: dragging in proportion, typing absolutely.

#include <cmath>

#include "tests/app/tool_rig.hpp"
#include "ui/polyhedron/tension_tool.hpp"

namespace hariko::test {
namespace {

TEST(TensionTool, DragsInProportionAndTypesAbsolutely) {
  Rig rig;
  const ObjectId id = rig.editor.document().objects[0]->id;
  const EdgeId first = EdgeId::of({4}, {5}), second = EdgeId::of({5}, {6});
  rig.editor.commit(set_beta(rig.editor.document(), id, {&first, 1}, 4), "Tension");
  const Document before = rig.editor.document();
  rig.editor.mode = ElementMode::edge;
  rig.editor.selection.select({id, element_of(first)}, Selection::How::add);
  rig.editor.selection.select({id, element_of(second)}, Selection::How::add);
  const auto beta = [&](EdgeId edge) { return rig.source().shaping->beta.get_or(edge, 1); };
  rig.start(std::make_unique<TensionTool>(), {300, 300});
  rig.move({300 + TensionTool::doubling_pixels, 320});
  EXPECT_DOUBLE_EQ(beta(first), 8);
  EXPECT_DOUBLE_EQ(beta(second), 2);
  rig.escape();
  EXPECT_EQ(rig.editor.document(), before);
  rig.start(std::make_unique<TensionTool>(), {300, 300});
  rig.move({300 + TensionTool::doubling_pixels, 320}, true);
  EXPECT_NEAR(beta(second), std::exp2(0.1), 0.01) << "Shift is fine";
  rig.type("25");
  EXPECT_EQ(beta(first), 25);
  EXPECT_EQ(beta(second), 25);
  rig.enter();
  EXPECT_EQ(rig.tool, nullptr);
  EXPECT_EQ(rig.editor.history.undo_label(), "Tension of edges");
  rig.editor.undo();
  EXPECT_EQ(rig.editor.document(), before);
  rig.choose({5});
  rig.start(std::make_unique<TensionTool>(), {300, 300});
  rig.type("5000");
  rig.enter();
  ASSERT_NE(rig.tool, nullptr) << "out of range: nothing happens but an explanation";
  rig.escape();
  EXPECT_EQ(rig.editor.document(), before);
}

}  // namespace
}  // namespace hariko::test

// LastOperation: numbers of the step just made change that step, as long as nothing came after it.

#include "ui/editor/last_operation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/document/edits/edits.hpp"
#include "core/modeling/objects/primitives.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {
namespace {

Result<OperationResult> add_prism(const Document& document, std::span<const OperationNumber> numbers) {
  auto mesh = make_primitive(PrismShape{static_cast<int>(numbers[0].value), numbers[1].value, 2, {}});
  if (!mesh) return mesh.error();
  auto added = add_object(document, "Prism", PolyhedronSource::from_mesh(*mesh).value());
  return OperationResult{added->document, added->id};
}

std::vector<OperationNumber> prism_numbers() {
  return {{"sides", "Sides", 6, 3, 128, true}, {"radius", "Radius", 1, 0, 1e12, false}};
}

Index sides_of(const Editor& editor) {
  return editor.active_object()->polyhedron()->polyhedron.vertex_count() / 2;
}

TEST(LastOperation, AdjustingStaysOneStep) {
  Editor editor;
  editor.open({}, std::nullopt);
  LastOperation& last = editor.last_operation;
  EXPECT_FALSE(last.can_adjust(editor));
  ASSERT_TRUE(last.run(editor, "Add prism", prism_numbers(), add_prism));
  EXPECT_EQ(sides_of(editor), 6U);
  for (const double sides : {8.0, 3.2, 1e9, -5.0, 12.0}) {
    last.adjust(editor, 0, sides);
    EXPECT_EQ(editor.history.position(), 1U);
    EXPECT_EQ(editor.history.undo_label(), "Add prism");
    EXPECT_EQ(sides_of(editor), static_cast<Index>(std::clamp(std::round(sides), 3.0, 128.0)));
  }
  editor.undo();
  EXPECT_TRUE(editor.document().objects.empty());
  EXPECT_FALSE(last.can_adjust(editor)) << "it was undone";
  editor.redo();
  EXPECT_TRUE(last.can_adjust(editor));
  EXPECT_EQ(sides_of(editor), 12U);
}

TEST(LastOperation, RefusedNumbersChangeNothing) {
  Editor editor;
  editor.open({}, std::nullopt);
  LastOperation& last = editor.last_operation;
  ASSERT_TRUE(last.run(editor, "Add prism", prism_numbers(), add_prism));
  const Document before = editor.document();
  EXPECT_FALSE(last.adjust(editor, 1, 0));
  EXPECT_FALSE(last.adjust(editor, 1, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(last.adjust(editor, 7, 1));
  EXPECT_TRUE(editor.document() == before);
  EXPECT_EQ(last.numbers()[1].value, 1);
  EXPECT_EQ(editor.history.position(), 1U);
}

TEST(LastOperation, EndsWithTheNextStep) {
  Editor editor;
  editor.open({}, std::nullopt);
  LastOperation& last = editor.last_operation;
  ASSERT_TRUE(last.run(editor, "Add prism", prism_numbers(), add_prism));
  editor.commit(rename_object(editor.history.current(), editor.selection.active, "Tower"), "Rename");
  EXPECT_FALSE(last.can_adjust(editor));
  EXPECT_FALSE(last.adjust(editor, 0, 5));
  EXPECT_EQ(editor.history.position(), 2U);
}

}  // namespace
}  // namespace hariko

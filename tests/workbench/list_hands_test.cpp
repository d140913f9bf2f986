// The list of objects and the history below it, by hand: rename in place, choose several, hide, isolate,
// lock, drag into order, go back to the beginning and forward again.

#include <algorithm>

#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

class ListByHand : public BenchHands {
 protected:
  ListByHand() : BenchHands(test::box(), {1280, 800}) { frames(); }
  const std::string& label() { return editor().history.undo_label(); }
  std::size_t position() { return editor().history.position(); }
  Vector2 middle_of(const std::string& mark) {
    const Marks::Rect rect = marks().at(mark);
    return {rect.x + rect.width / 2.0, rect.y + rect.height / 2.0};
  }
  /// Two copies beside the object; the rows of all three, from above.
  std::vector<std::string> three_rows() {
    for (int i = 0; i < 2; ++i) {
      tap("Ctrl+D");
      EXPECT_EQ(label(), "Duplicate object");
    }
    std::vector<std::string> rows{"object.1", "object.2", "object.3"};
    for (const std::string& row : rows) EXPECT_TRUE(marks().contains(row)) << row;
    std::sort(rows.begin(), rows.end(), [this](const std::string& a, const std::string& b) {
      return marks().at(a).y < marks().at(b).y;
    });
    return rows;
  }
  void choose_both(const std::string& first, const std::string& second) {
    click(first);
    bench_.hold(false, true, false);
    click(second);
    bench_.hold(false, false, false);
    frames();
  }
};

TEST_F(ListByHand, ADoubleClickAndF2MakeTheNameAFieldAndEscKeepsIt) {
  click(middle_of("object.1") - Vector2(40, 0), 2);
  frames();
  ASSERT_TRUE(marks().contains("outliner.name"));
  bench_.type("Body");
  tap("Enter");
  EXPECT_EQ(label(), "Rename object");
  EXPECT_EQ(objects()[0]->name, "Body");
  tap("F2");
  ASSERT_TRUE(marks().contains("outliner.name"));
  bench_.type("Nothing");
  tap("Esc");
  EXPECT_FALSE(marks().contains("outliner.name"));
  EXPECT_EQ(position(), 1U) << "Esc renamed the object";
  EXPECT_EQ(objects()[0]->name, "Body");
}

TEST_F(ListByHand, SeveralAreHiddenShownAndIsolated) {
  const std::vector<std::string> rows = three_rows();
  choose_both(rows[0], rows[2]);
  tap("H");
  EXPECT_EQ(label(), "Hide 2 objects");
  tap("Alt+H");
  EXPECT_EQ(label(), "Show all objects");
  // Hidden objects are no longer selected.
  choose_both(rows[0], rows[2]);
  tap("Shift+H");
  EXPECT_EQ(label(), "Isolate 2 objects");
  tap("Ctrl+Z");
  EXPECT_EQ(label(), "Show all objects");
}

TEST_F(ListByHand, RowsAreDraggedSwitchedAndUndoneInTheHistory) {
  const std::vector<std::string> rows = three_rows();
  click(rows[1]);
  click(rows[0]);
  frames(8);
  const Marks::Rect last = marks().at(rows[2]);
  const Vector2 from = middle_of(rows[0]) - Vector2(40, 0),
                to(last.x + last.width / 2.0 - 40, last.y + last.height - 3.0);
  move_to(from);
  bench_.press();
  for (int i = 1; i <= 6; ++i) move_to(from + (to - from) * i / 6);
  frames(2);
  bench_.release();
  frames();
  EXPECT_EQ(label(), "Reorder objects");
  EXPECT_GT(marks().at(rows[0]).y, marks().at(rows[2]).y) << "the row did not move";

  const std::string number = rows[1].substr(std::string("object").size());
  click("eye" + number);
  EXPECT_EQ(label(), "Hide object");
  move_to(middle_of(rows[1]));
  frames();
  ASSERT_TRUE(marks().contains("lock" + number));
  click("lock" + number);
  EXPECT_EQ(label(), "Lock object");

  const std::size_t steps = position();
  EXPECT_EQ(steps, 5U);
  click("section.history");
  ASSERT_TRUE(marks().contains("step.0"));
  // New steps come into view, and the beginning may be above it.
  move_to(middle_of("step." + std::to_string(steps)));
  for (int i = 0; i < 12; ++i) bench_.wheel(1);
  frames();
  click("step.0");
  EXPECT_EQ(position(), 0U);
  EXPECT_EQ(objects().size(), 1U);
  click("step.1");
  EXPECT_EQ(position(), 1U);
}

}  // namespace
}  // namespace hariko::test

// Groups in the list of objects, by mouse and keys.

#include "core/document/group_tree.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

class GroupHands : public BenchHands {
 protected:
  GroupHands() : BenchHands(row()) {}
  static Document row() { return duplicate_objects(test::box(), std::vector{ObjectId{1}}, 3)->document; }
  void SetUp() override {
    editor().mode = ElementMode::object;
    frames();
  }
  const Document& document() { return editor().history.current(); }
  static std::string row_of(std::uint32_t object) { return "object." + std::to_string(object); }
  /// Chooses rows, the later ones with Ctrl.
  void choose(std::initializer_list<std::uint32_t> objects) {
    bool first = true;
    for (const std::uint32_t object : objects) {
      bench_.hold(false, !first, false);
      bench_.click(row_of(object));
      first = false;
    }
    bench_.hold(false, false, false);
    frames();
  }
  /// Drags a row to a place of another one, `share` of its height below its upper end.
  void drag(const std::string& from, const std::string& to, double share) {
    ASSERT_TRUE(marks().contains(from)) << from;
    ASSERT_TRUE(marks().contains(to)) << to;
    const Marks::Rect start = marks().at(from), end = marks().at(to);
    // The middle of the name: buttons stand at both ends.
    const double x = start.x + 0.4 * start.width, y = end.y + share * end.height;
    bench_.move(x, start.y + start.height / 2.0);
    bench_.press();
    for (int i = 1; i <= 4; ++i)
      bench_.move(x, start.y + start.height / 2.0 + i * (y - start.y - start.height / 2.0) / 4);
    frames(2);
    bench_.release();
    frames();
  }
  GroupId group_of(std::uint32_t object) { return document().find(ObjectId{object})->group; }
  std::vector<std::uint32_t> order() {
    std::vector<std::uint32_t> ids;
    for (const auto& object : document().objects) ids.push_back(object->id.value);
    return ids;
  }
};

TEST_F(GroupHands, CtrlGGroupsWhatIsChosenAndCtrlZTakesItBack) {
  const Document before = document();
  choose({2, 3});
  tap("Ctrl+G");
  ASSERT_EQ(document().groups->size(), 1U);
  EXPECT_EQ(group_of(2), GroupId{1});
  EXPECT_EQ(group_of(3), GroupId{1});
  EXPECT_EQ(group_of(1), GroupId{});
  ASSERT_TRUE(marks().contains("group.1"));
  EXPECT_LT(marks().at("group.1").y, marks().at(row_of(2)).y);
  EXPECT_EQ(editor().chosen_group.chosen(editor()), GroupId{1});
  tap("Ctrl+Shift+G");
  EXPECT_TRUE(document() == before) << "dissolving does not give the old document back";
  tap("Ctrl+Z");
  EXPECT_EQ(document().groups->size(), 1U);
  tap("Ctrl+Z");
  EXPECT_TRUE(document() == before);
  EXPECT_FALSE(marks().contains("group.1"));
}

TEST_F(GroupHands, ARowIsDraggedIntoAGroupAndOutAgain) {
  choose({2, 3});
  tap("Ctrl+G");
  const Document grouped = document();
  drag(row_of(4), "group.1", 0.5);
  EXPECT_EQ(group_of(4), GroupId{1});
  EXPECT_EQ(order(), (std::vector<std::uint32_t>{1, 2, 3, 4})) << "at the end of the group";
  tap("Ctrl+Z");
  EXPECT_TRUE(document() == grouped);
  // A place between two rows of the group.
  drag(row_of(4), row_of(3), 0.2);
  EXPECT_EQ(group_of(4), GroupId{1});
  EXPECT_EQ(order(), (std::vector<std::uint32_t>{1, 2, 4, 3}));
  // The place above the first row, which lies in no group.
  drag(row_of(4), row_of(1), 0.2);
  EXPECT_EQ(group_of(4), GroupId{});
  EXPECT_EQ(order(), (std::vector<std::uint32_t>{4, 1, 2, 3}));
  // The group itself goes up as a whole.
  drag("group.1", row_of(4), 0.2);
  EXPECT_EQ(order(), (std::vector<std::uint32_t>{2, 3, 4, 1}));
  EXPECT_EQ(group_of(2), GroupId{1});
}

TEST_F(GroupHands, TheEyeOfAGroupHidesWhatItContainsAndUndoShowsIt) {
  choose({2, 3});
  tap("Ctrl+G");
  const Document grouped = document();
  click("group.eye.1");
  EXPECT_FALSE(document().find(ObjectId{2})->visible);
  EXPECT_FALSE(document().find(ObjectId{3})->visible);
  EXPECT_TRUE(document().find(ObjectId{1})->visible);
  EXPECT_FALSE(editor().selection.objects().contains(ObjectId{2})) << "what is hidden stays selected";
  bench_.workbench().commands().run("select.all");
  EXPECT_EQ(editor().selection.objects().size(), 2U);
  tap("Ctrl+Z");
  EXPECT_TRUE(document() == grouped);
  EXPECT_TRUE(document().find(ObjectId{2})->visible);
}

TEST_F(GroupHands, TheLockOfAGroupRefusesEdits) {
  choose({2, 3});
  tap("Ctrl+G");
  const Marks::Rect group = marks().at("group.1");
  bench_.move(group.x + 0.5 * group.width, group.y + 0.5 * group.height);
  frames();
  ASSERT_TRUE(marks().contains("group.lock.1"));
  click("group.lock.1");
  const Document locked = document();
  ASSERT_TRUE(locked.find(ObjectId{2})->locked);
  bench_.workbench().commands().run("select.all");
  EXPECT_EQ(editor().selection.objects().size(), 2U) << "locked objects are selected";
  click(row_of(2));
  EXPECT_FALSE(bench_.workbench().commands().run("transform.move").ran);
  tap("Shift+Del");
  EXPECT_TRUE(document() == locked);
  tap("Ctrl+Z");
  EXPECT_FALSE(document().find(ObjectId{2})->locked);
}

TEST_F(GroupHands, AFoldedGroupShowsNoRowsUntilAnObjectInItIsChosen) {
  choose({2, 3});
  tap("Ctrl+G");
  click("group.fold.1");
  EXPECT_FALSE(marks().contains(row_of(2)));
  click("group.1");
  EXPECT_FALSE(marks().contains(row_of(2))) << "choosing the group opens it";
  EXPECT_EQ(editor().selection.objects().size(), 2U);
  click(row_of(1));
  editor().selection.active = ObjectId{3};
  frames();
  EXPECT_TRUE(marks().contains(row_of(3)));
}

TEST_F(GroupHands, F2RenamesTheChosenGroup) {
  choose({2, 3});
  tap("Ctrl+G");
  tap("F2");
  bench_.type("Wheels");
  tap("Enter");
  EXPECT_EQ(document().groups->front().name, "Wheels");
  tap("Ctrl+Z");
  EXPECT_NE(document().groups->front().name, "Wheels");
}

TEST_F(GroupHands, SelectGroupGoesFromTheInnermostGroupOutward) {
  choose({2, 3});
  bench_.tap("Ctrl+G");
  choose({1, 2, 3});
  tap("Ctrl+G");
  ASSERT_EQ(document().groups->size(), 2U);
  EXPECT_EQ(find_group(*document().groups, GroupId{1})->parent, GroupId{2});
  click(row_of(3));
  bench_.workbench().commands().run("group.select");
  EXPECT_EQ(editor().chosen_group.chosen(editor()), GroupId{1});
  bench_.workbench().commands().run("group.select");
  EXPECT_EQ(editor().chosen_group.chosen(editor()), GroupId{2});
  EXPECT_EQ(editor().selection.objects().size(), 3U);
}

}  // namespace
}  // namespace hariko::test

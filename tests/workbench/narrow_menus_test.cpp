// The bars of a narrow window: every menu can be reached and nothing ends outside, whatever the language and
// the size of the interface.

#include "core/document/file.hpp"
#include "tests/workbench/bench_hands.hpp"

namespace hariko::test {
namespace {

class NarrowMenus : public BenchHands {
 protected:
  NarrowMenus()
      : BenchHands(load_document(source_folder() + "/assets/samples/fig2.hariko").value(), {800, 600}) {
    bench_.wait_for_surfaces();
  }
  void expect_inside(const std::string& mark) {
    ASSERT_TRUE(marks().contains(mark)) << mark;
    const Marks::Rect rect = marks().at(mark);
    EXPECT_GE(rect.x, 0) << mark;
    EXPECT_LE(rect.x + rect.width, 800) << mark;
  }
  /// By way of the menu for those without room where there is one.
  void open_last_menu() {
    frames(6);
    expect_inside("menu.search");
    expect_inside("status.right");
    if (marks().contains("menu.Help")) {
      const Marks::Rect help = marks().at("menu.Help");
      EXPECT_LE(help.x + help.width, marks().at("menu.search").x) << "the last menu lies under the field";
    } else {
      expect_inside("menu.more");
      click("menu.more");
    }
    click("menu.Help");
    EXPECT_TRUE(marks().contains("command.help.about"));
  }
};

TEST_F(NarrowMenus, HaveRoomBesideAButton) {
  open_last_menu();
  EXPECT_FALSE(marks().contains("menu.more"));
  EXPECT_TRUE(marks().contains("command.language.japanese"));
}

TEST_F(NarrowMenus, CanBeReachedInJapaneseAndSoCanThePalette) {
  editor().language = Language::load(source_folder() + "/assets/languages/ja.po").value();
  FontRequest fonts;
  for (const char32_t character : editor().language.characters()) fonts.characters.insert(character);
  bench_.set_fonts(fonts);
  open_last_menu();
  tap("Esc");
  tap("Esc");
  click("menu.search");
  EXPECT_TRUE(marks().contains("palette.input"));
}

TEST_F(NarrowMenus, OfALargeInterfaceStandInOneAtTheEnd) {
  bench_.set_scale(1.5F);
  open_last_menu();
  EXPECT_TRUE(marks().contains("menu.more"));
}

TEST_F(NarrowMenus, LeaveHalfOfTheStatusLineToTheKeysOfATool) {
  run("select.edges");
  run("select.all");
  run("shape.crease");
  bench_.wait_for_surfaces();
  run("mesh.loop_cut");
  frames(6);
  EXPECT_GE(marks().at("status.left").width, 340);
  expect_inside("status.right");
}

}  // namespace
}  // namespace hariko::test

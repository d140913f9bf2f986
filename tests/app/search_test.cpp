// Fuzzy search, and searching the command table.

#include <gtest/gtest.h>

#include "tests/support/places.hpp"
#include "ui/base/fuzzy.hpp"
#include "ui/editor/command_search.hpp"

namespace hariko {
namespace {

TEST(Fuzzy, FindsPiecesAndInitials) {
  for (const auto& [query, text] : {std::pair{"frame", "Frame all"},
                                    {"all", "Frame all"},
                                    {"fa", "Frame all"},
                                    {"FRAME ALL", "Frame all"},
                                    {"all frame", "Frame all"},
                                    {"ram", "Frame all"},
                                    {"fs", "Frame selection"},
                                    {"frsel", "Frame selection"},
                                    {"", "anything"},
                                    {"  ", "anything"},
                                    {"面", "正面"},
                                    {"全体", "ビューを全体表示"},
                                    {"ｆｒａ", "Frame all"}})
    EXPECT_GT(fuzzy_score(query, text), 0) << query << " in " << text;
  for (const auto& [query, text] : {std::pair{"x", "Frame all"},
                                    {"rl", "Frame all"},
                                    {"zebra", "Analyse the borders in every area"},
                                    {"framez", "Frame all"},
                                    {"laf", "Frame all"},
                                    {"frame x", "Frame all"},
                                    {"a", ""},
                                    {"左", "右"}})
    EXPECT_EQ(fuzzy_score(query, text), 0) << query << " in " << text;
}

TEST(Fuzzy, RanksTheBetterMatchHigher) {
  const auto better = [](const char* query, const char* first, const char* second) {
    EXPECT_GT(fuzzy_score(query, first), fuzzy_score(query, second))
        << query << ": " << first << ", " << second;
  };
  better("frame", "Frame all", "Key frame");
  better("top", "Top", "Stop");
  better("save", "Save", "Save as\u2026");
  better("sa", "Save as\u2026", "Select all");
  better("select", "Select all", "Deselect");
}

TEST(Fuzzy, SentencesAreFoundByTheirWordsShortOnesIncluded) {
  const char* sentence = "Show the program in this language.";
  for (const char* query :
       {"Show the program in this language.", "program in", "in this language", "LANGUAGE"})
    EXPECT_TRUE(holds_words(query, sentence)) << query;
  for (const char* query : {"", "in", "in of", "program on", "gram", "show x"})
    EXPECT_FALSE(holds_words(query, sentence)) << query;
}

Command command(const char* id, const char* menu, const char* label, const char* help) {
  Command c;
  c.id = id;
  c.menu = menu;
  c.label = label;
  c.help = help;
  c.run = [] {};
  return c;
}

CommandTable table() {
  CommandTable t;
  t.add(command("a", "View", "Frame all", "Show everything."));
  t.add(command("b", "View", "Frame selection", "Come close to what is selected."));
  t.add(command("c", "View/Standard views", "Top", "Look from this side."));
  t.add(command("d", "Edit", "Undo", "Take back the last step of the frame."));
  return t;
}

std::string ids(const std::vector<const Command*>& found) {
  std::string out;
  for (const Command* c : found) out += c->id;
  return out;
}

TEST(CommandSearch, LooksAtLabelsMenusAndHelp) {
  const CommandTable t = table();
  const Language english;
  EXPECT_EQ(ids(search_commands(t, english, "", {})), "abcd");
  EXPECT_EQ(ids(search_commands(t, english, "frame", {})), "abd");  // the help of d comes last
  EXPECT_EQ(ids(search_commands(t, english, "frame sel", {})).front(), 'b');
  EXPECT_EQ(ids(search_commands(t, english, "standard", {})), "c");
  EXPECT_EQ(ids(search_commands(t, english, "view top", {})).front(), 'c');
  EXPECT_EQ(ids(search_commands(t, english, "everything", {})), "a");
  EXPECT_EQ(ids(search_commands(t, english, "qqq", {})), "");
}

TEST(CommandSearch, FindsOtherNamesEachAloneAndBehindLabels) {
  CommandTable t = table();
  t.call_also("d", "rewind, top secret");
  const Language english;
  EXPECT_EQ(ids(search_commands(t, english, "rewind", {})), "d");
  EXPECT_EQ(ids(search_commands(t, english, "top", {})), "cd");
  EXPECT_EQ(ids(search_commands(t, english, "rewind secret", {})), "") << "words of two names";
}

TEST(CommandSearch, PutsRecentOnesFirst) {
  const CommandTable t = table();
  const std::vector<std::string> recent{"d", "b", "gone"};
  EXPECT_EQ(ids(search_commands(t, {}, "", recent)), "dbac");
  EXPECT_EQ(ids(search_commands(t, {}, "frame", recent)).front(), 'b');
}

TEST(CommandSearch, KnowsBothLanguages) {
  const auto japanese = Language::load(test::source_folder() + "/assets/languages/ja.po");
  ASSERT_TRUE(japanese.ok());
  CommandTable t;
  t.add(command("undo", "Edit", "Undo", ""));
  t.add(command("all", "View", "Frame all", ""));
  const std::string undo = (*japanese)(std::string("Undo"));
  ASSERT_NE(undo, "Undo");
  EXPECT_EQ(ids(search_commands(t, *japanese, undo, {})).substr(0, 4), "undo");
  EXPECT_EQ(ids(search_commands(t, *japanese, "undo", {})), "undo");
}

}  // namespace
}  // namespace hariko

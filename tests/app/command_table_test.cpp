#include "ui/editor/command_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "ui/editor/command_host.hpp"

namespace hariko {
namespace {

TEST(KeyChord, ReadsAndWritesItsText) {
  for (const char* text : {"Ctrl+Z", "Ctrl+Shift+Z", "Del", "Home",   "Num 1", "Ctrl+Num 3", "1",
                           "F3",     "Alt+F1",       "Esc", "F25",    "?",     "Ctrl+?",     "/",
                           "Ctrl+/", "Num Slash",    ",",   "Ctrl+,", "PgUp",  "Shift+["}) {
    const auto chord = KeyChord::parse(text);
    ASSERT_TRUE(chord.has_value()) << text;
    EXPECT_EQ(chord->to_string(), text);
  }
  EXPECT_EQ(KeyChord::parse("Ctrl+Shift+Z"), (KeyChord{Key::z, true, true, false}));
  EXPECT_EQ(KeyChord::parse("Shift+Ctrl+Z"), (KeyChord{Key::z, true, true, false}));
  EXPECT_EQ(KeyChord::parse("Shift+/"), KeyChord::parse("?"));
  for (const char* text : {"", "Ctrl+", "z", "Foo", "Ctrl+Foo", "Z+Ctrl", "Ctrl+ZZ", "F0", "F26", "Num",
                           "Num 10", "\xc3\xa9", "Ctrl++", "Shift+?"})
    EXPECT_FALSE(KeyChord::parse(text).has_value()) << text;
}

TEST(KeyChord, EveryChordComesBackFromItsText) {
  const auto chords = all_chords();
  EXPECT_GT(chords.size(), 8U * 90U);
  std::set<std::string> texts;
  for (const KeyChord& chord : chords) {
    EXPECT_EQ(KeyChord::parse(chord.to_string()), chord) << chord.to_string();
    EXPECT_TRUE(texts.insert(chord.to_string()).second) << chord.to_string() << " names two keys";
  }
  // Several at once, whatever they are: "/" is a key and the separator.
  for (std::size_t i = 0; i + 2 < chords.size(); i += 3) {
    const std::vector<KeyChord> three(chords.begin() + static_cast<std::ptrdiff_t>(i),
                                      chords.begin() + static_cast<std::ptrdiff_t>(i + 3));
    EXPECT_EQ(parse_keys(print_keys(three)), three) << print_keys(three);
  }
  EXPECT_EQ(parse_keys(""), std::vector<KeyChord>{});
  for (const char* text : {" / ", "A / ", " / A", "A/B", "A / foo"})
    EXPECT_FALSE(parse_keys(text).has_value()) << text;
}

TEST(CommandTable, RunsOrSaysWhyNot) {
  CommandTable table;
  int runs = 0;
  bool allowed = false;
  Command command;
  command.id = "test.run";
  command.menu = "Test";
  command.keys = "Ctrl+R / Num 5";
  command.run = [&] { ++runs; };
  command.why_not = [&]() -> std::optional<std::string> {
    if (allowed) return {};
    return "Not yet.";
  };
  table.add(command);
  std::vector<std::string> heard;
  table.after_run([&](const Command& c, const CommandTable::Outcome& outcome) {
    heard.push_back(c.id + (outcome.ran ? " ran" : " " + outcome.reason));
  });
  EXPECT_EQ(table.run("test.run").reason, "Not yet.");
  EXPECT_EQ(runs, 0);
  allowed = true;
  EXPECT_TRUE(table.run("test.run").ran);
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(heard, (std::vector<std::string>{"test.run Not yet.", "test.run ran"}));
  ASSERT_NE(table.find(*KeyChord::parse("Num 5")), nullptr);
  EXPECT_EQ(table.find(*KeyChord::parse("Ctrl+R"))->id, "test.run");
  EXPECT_EQ(table.find(*KeyChord::parse("R")), nullptr);
  EXPECT_EQ(table.menus(), std::vector<std::string>{"Test"});
}

TEST(CommandRows, AReasonOnTopOfAnotherIsAskedAfterIt) {
  bool open = false, chosen = false;
  int asked = 0;
  const WhyNot document = only_if([&] { return open; }, "Nothing is open.");
  const auto is_chosen = [&] {
    ++asked;
    return chosen;
  };
  const WhyNot choice = only_if(document, is_chosen, "Nothing is chosen.");
  EXPECT_EQ(choice(), "Nothing is open.");
  EXPECT_EQ(asked, 0);
  open = true;
  EXPECT_EQ(choice(), "Nothing is chosen.");
  chosen = true;
  EXPECT_FALSE(choice().has_value());
}

TEST(CommandRows, ASwitchTurnsItsValueRoundAndShowsIt) {
  bool on = false;
  const Command row = switching({.id = "a", .keys = "G"}, on);
  EXPECT_EQ(row.id, "a");
  EXPECT_EQ(row.keys, "G");
  for (const bool expected : {true, false}) {
    row.run();
    EXPECT_EQ(on, expected);
    EXPECT_EQ(row.checked(), expected);
  }
}

TEST(CommandTableDeathTest, RefusesASecondUseOfAnIdOrAKey) {
  CommandTable table;
  Command first;
  first.id = "a";
  first.keys = "C";
  first.run = [] {};
  table.add(first);
  EXPECT_DEATH(table.add(first), "id already taken");
  Command second = first;
  second.id = "b";
  EXPECT_DEATH(table.add(second), "key already taken");
  second.keys = "Hyper+C";
  EXPECT_DEATH(table.add(second), "unknown key name");
}

/// Commands a (A), b (B / F2), c (no key).
CommandTable three_commands() {
  CommandTable table;
  for (const auto& [id, keys] : std::map<std::string, std::string>{{"a", "A"}, {"b", "B / F2"}, {"c", ""}}) {
    Command command;
    command.id = id;
    command.menu = "M";
    command.keys = keys;
    command.run = [] {};
    table.add(std::move(command));
  }
  return table;
}

using Overrides = std::map<std::string, std::string>;

TEST(Rebinding, ReplacesDefaultsAndGivesThemBack) {
  CommandTable table = three_commands();
  EXPECT_TRUE(table.rebind({{"a", "Ctrl+A"}, {"c", "F5 / F6"}}).empty());
  EXPECT_EQ(table.find(*KeyChord::parse("A")), nullptr);
  EXPECT_EQ(table.find(*KeyChord::parse("Ctrl+A"))->id, "a");
  EXPECT_EQ(table.find(*KeyChord::parse("F6"))->id, "c");
  EXPECT_EQ(table.find("c")->keys, "F5 / F6");
  EXPECT_EQ(table.find("a")->default_keys, "A");
  EXPECT_TRUE(table.rebind({{"b", ""}}).empty());
  EXPECT_EQ(table.find(*KeyChord::parse("A"))->id, "a");
  EXPECT_EQ(table.find(*KeyChord::parse("B")), nullptr);
  EXPECT_EQ(table.find("b")->keys, "");
  EXPECT_TRUE(table.rebind({}).empty());
  EXPECT_EQ(table.find("b")->keys, "B / F2");
}

TEST(Rebinding, AnOverrideTakesAKeyFromADefault) {
  CommandTable table = three_commands();
  EXPECT_TRUE(table.rebind({{"c", "F2"}}).empty());
  EXPECT_EQ(table.find(*KeyChord::parse("F2"))->id, "c");
  EXPECT_EQ(table.find("b")->keys, "B");
}

TEST(Rebinding, NamesWhatItCannotUse) {
  CommandTable table = three_commands();
  const auto problems =
      table.rebind({{"a", "F2 / F2"}, {"b", "Hyper+B"}, {"c", "F2 / Esc / F7"}, {"gone", "G"}});
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0].kind, KeyProblem::Kind::not_a_key);
  EXPECT_EQ(problems[0].id, "b");
  EXPECT_EQ(problems[1].kind, KeyProblem::Kind::taken);
  EXPECT_EQ(problems[1].other, "a");
  EXPECT_EQ(problems[2].kind, KeyProblem::Kind::reserved);
  EXPECT_EQ(problems[3].kind, KeyProblem::Kind::unknown_command);
  EXPECT_EQ(table.find("a")->keys, "F2");
  EXPECT_EQ(table.find("b")->keys, "B");  // its default, but for what another override took
  EXPECT_EQ(table.find("c")->keys, "F7");
  EXPECT_EQ(table.find(*KeyChord::parse("Esc")), nullptr);
}

TEST(Rebinding, ReplacingTakesTheKeyFromItsOwner) {
  CommandTable table = three_commands();
  const std::vector<KeyChord> keys{*KeyChord::parse("B"), *KeyChord::parse("A")};
  Overrides overrides = table.with_keys({}, "c", keys);
  EXPECT_EQ(overrides, (Overrides{{"a", ""}, {"b", "F2"}, {"c", "B / A"}}));
  EXPECT_TRUE(table.rebind(overrides).empty());
  // Back to the default: the entry goes, and the key returns to nobody else.
  overrides = table.with_keys(overrides, "a", *parse_keys("A"));
  EXPECT_EQ(overrides, (Overrides{{"b", "F2"}, {"c", "B"}}));
  EXPECT_TRUE(table.rebind(overrides).empty());
  EXPECT_EQ(table.find(*KeyChord::parse("A"))->id, "a");
}

TEST(Rebinding, AfterAnyEditsNoKeyHasTwoOwners) {
  const auto chords = all_chords();
  CommandTable table = three_commands();
  Overrides overrides;
  std::mt19937 random(7);
  for (int step = 0; step < 2000; ++step) {
    std::vector<KeyChord> keys;
    for (std::size_t n = random() % 3; n > 0; --n) {
      // Few keys, so that they collide.
      const KeyChord chord{Key::a + static_cast<int>(random() % 4), random() % 2 == 0};
      if (std::find(keys.begin(), keys.end(), chord) == keys.end()) keys.push_back(chord);
    }
    const std::string id(1, static_cast<char>('a' + random() % 3));
    overrides = table.with_keys(overrides, id, keys);
    ASSERT_TRUE(table.rebind(overrides).empty()) << "step " << step;
    ASSERT_EQ(table.find(id)->keys, print_keys(keys)) << "step " << step;
    std::set<std::string> taken;
    for (const Command& command : table.all()) {
      const auto own = parse_keys(command.keys).value();
      for (const KeyChord& chord : own) {
        ASSERT_TRUE(taken.insert(chord.to_string()).second) << "step " << step;
        ASSERT_EQ(table.find(chord), &command);
      }
    }
  }
}

TEST(MenuTree, FollowsTheTable) {
  CommandTable table;
  const auto add = [&](const char* id, const char* menu, bool separator, Context contexts) {
    Command command;
    command.id = id;
    command.menu = menu;
    command.separator_before = separator;
    command.contexts = contexts;
    command.run = [] {};
    table.add(std::move(command));
  };
  add("a", "View", false, Context::empty);
  add("b", "View/Standard", true, Context::vertex | Context::empty);
  add("c", "Edit", true, Context::vertex);
  add("d", "View", false, Context::none);
  add("e", "View/Standard", true, Context::empty);
  add("f", "", false, Context::vertex);
  EXPECT_EQ(table.menus(), (std::vector<std::string>{"Edit", "View"}));
  const auto view = menu_tree(table, "View");
  ASSERT_EQ(view.size(), 3U);
  EXPECT_EQ(view[0].command->id, "a");
  EXPECT_EQ(view[1].submenu, "Standard");
  EXPECT_TRUE(view[1].separator_before);
  ASSERT_EQ(view[1].children.size(), 2U);
  EXPECT_FALSE(view[1].children[0].separator_before);  // nothing above it
  EXPECT_TRUE(view[1].children[1].separator_before);
  EXPECT_EQ(view[2].command->id, "d");
  EXPECT_FALSE(menu_tree(table, "Edit").front().separator_before);
  const auto vertex = context_menu_tree(table, Context::vertex);
  ASSERT_EQ(vertex.size(), 2U);
  EXPECT_EQ(vertex[0].command->id, "c");
  EXPECT_FALSE(vertex[0].separator_before);
  EXPECT_EQ(vertex[1].submenu, "Standard");
  EXPECT_TRUE(vertex[1].separator_before);  // another menu begins
  EXPECT_TRUE(context_menu_tree(table, Context::face).empty());
  table.show_in(Context::face, {"d", "a"});
  EXPECT_EQ(context_menu_tree(table, Context::face).size(), 2U);
}

}  // namespace
}  // namespace hariko

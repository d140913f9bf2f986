#include "ui/command_table.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace hariko {
namespace {

TEST(KeyChord, ReadsAndWritesItsText) {
  for (const char* text :
       {"Ctrl+Z", "Ctrl+Shift+Z", "Del", "Home", "Num 1", "Ctrl+Num 3", "1", "F3", "Alt+F1", "Esc"}) {
    const auto chord = KeyChord::parse(text);
    ASSERT_TRUE(chord.has_value()) << text;
    EXPECT_EQ(chord->to_string(), text);
  }
  EXPECT_EQ(KeyChord::parse("Ctrl+Shift+Z"), (KeyChord{GLFW_KEY_Z, true, true, false}));
  EXPECT_EQ(KeyChord::parse("Shift+Ctrl+Z"), (KeyChord{GLFW_KEY_Z, true, true, false}));
  for (const char* text : {"", "Ctrl+", "z", "Foo", "Ctrl+Foo", "Z+Ctrl", "Ctrl+ZZ"})
    EXPECT_FALSE(KeyChord::parse(text).has_value()) << text;
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
  EXPECT_EQ(table.run("test.run").reason, "Not yet.");
  EXPECT_EQ(runs, 0);
  allowed = true;
  EXPECT_TRUE(table.run("test.run").ran);
  EXPECT_EQ(runs, 1);
  ASSERT_NE(table.find(*KeyChord::parse("Num 5")), nullptr);
  EXPECT_EQ(table.find(*KeyChord::parse("Ctrl+R"))->id, "test.run");
  EXPECT_EQ(table.find(*KeyChord::parse("R")), nullptr);
  EXPECT_EQ(table.menus(), std::vector<std::string>{"Test"});
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

}  // namespace
}  // namespace hariko

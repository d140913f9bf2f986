// The settings file: what is written comes back, and nothing in it keeps the program from starting.

#include "app/persistence/settings_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

Settings unusual() {
  Settings settings;
  settings.theme = ThemeId::light;
  settings.language = LanguageId::japanese;
  settings.interface_scale = 1.75F;
  settings.colour_blind_maps = true;
  settings.unit = Unit::inch;
  settings.navigation = NavigationPreset::rhino;
  settings.trackball = true;
  settings.zoom_to_cursor = false;
  settings.invert_wheel = true;
  settings.orbit_selection = true;
  settings.orbit_speed = 0.3;
  settings.zoom_speed = 2.5;
  settings.autosave_seconds = 7;
  settings.keys = {{"view.frame_all", "F9"}, {"edit.undo", ""}};
  settings.side_width = 401;
  return settings;
}

class SettingsFileTest : public ::testing::Test {
 protected:
  SettingsFile::Loaded load() { return SettingsFile(path_).load(); }
  test::TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "config" / "settings.json";
};

TEST_F(SettingsFileTest, WhatIsWrittenComesBack) {
  ASSERT_TRUE(load().problems.empty()) << "a missing file is no problem";
  EXPECT_EQ(load().settings, Settings{});
  ASSERT_TRUE(SettingsFile(path_).save(unusual()).ok());
  const auto loaded = load();
  EXPECT_TRUE(loaded.problems.empty());
  EXPECT_EQ(loaded.settings, unusual());
  EXPECT_EQ(settings_of(settings_text(unusual())), unusual());
  EXPECT_EQ(settings_of("no json"), Settings{});
}

TEST_F(SettingsFileTest, WrongValuesHaveTheirDefaultsAndAreNamed) {
  fs::create_directories(path_.parent_path());
  test::spill(path_, R"({"theme": "pink", "autosave_seconds": 1000, "trackball": 1, "orbit_speed": "fast",
                         "keys": {"edit.undo": 3, "edit.redo": "F8"}, "zoom_speed": 2})");
  const auto loaded = load();
  ASSERT_EQ(loaded.problems.size(), 1U);
  EXPECT_EQ(loaded.problems[0].code, w_settings_value);
  for (const char* name : {"theme", "autosave_seconds", "trackball", "orbit_speed", "keys.edit.undo"})
    EXPECT_NE(loaded.problems[0].text.find(name), std::string::npos) << name;
  Settings expected;
  expected.zoom_speed = 2;
  expected.keys = {{"edit.redo", "F8"}};
  EXPECT_EQ(loaded.settings, expected);
}

TEST_F(SettingsFileTest, ABrokenFileIsPutAsideAndKept) {
  fs::create_directories(path_.parent_path());
  for (const char* broken : {"{\"theme\": ", "[1]", "\xff"}) {
    test::spill(path_, broken);
    const auto loaded = load();
    ASSERT_EQ(loaded.problems.size(), 1U) << broken;
    EXPECT_EQ(loaded.problems[0].code, w_settings_broken);
    EXPECT_EQ(loaded.settings, Settings{});
    EXPECT_FALSE(fs::exists(path_));
  }
  // None overwrote another.
  int kept = 0;
  for (const auto& entry : fs::directory_iterator(path_.parent_path()))
    kept += entry.path().filename().string().find("broken") != std::string::npos;
  EXPECT_EQ(kept, 3);
}

TEST_F(SettingsFileTest, MembersOfALaterVersionAreKept) {
  fs::create_directories(path_.parent_path());
  test::spill(path_, R"({"of_a_later_version": [1, {"a": 2}], "theme": "light"})");
  SettingsFile file(path_);
  Settings settings = file.load().settings;
  EXPECT_EQ(settings.theme, ThemeId::light);
  settings.theme = ThemeId::dark;
  ASSERT_TRUE(file.save(settings).ok());
  const std::string text = test::slurp(path_);
  EXPECT_NE(text.find("of_a_later_version"), std::string::npos);
  EXPECT_EQ(load().settings.theme, ThemeId::dark);
}

TEST_F(SettingsFileTest, AFileThatCannotBeReadOrWrittenSaysSo) {
  test::spill(folder_.path() / "config", "a file where the folder should be");
  EXPECT_FALSE(SettingsFile(path_).save({}).ok());
  fs::remove(folder_.path() / "config");
  fs::create_directories(path_);  // a folder where the file should be
  const auto loaded = load();
  EXPECT_EQ(loaded.problems.size(), 1U);
  EXPECT_EQ(loaded.settings, Settings{});
}

}  // namespace
}  // namespace hariko

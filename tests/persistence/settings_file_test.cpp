// The settings file: what is written comes back, and nothing in it keeps the program from starting.

#include "app/persistence/settings_file.hpp"

#include <cmath>

#include "tests/support/random.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

Settings unusual() {
  Settings settings;
  settings.theme = ThemeId::light;
  settings.language = "japanese";
  settings.interface_scale = 1.75F;
  settings.colour_blind_maps = true;
  settings.unit = Unit::inch;
  settings.navigation = NavigationPreset::rhino;
  settings.trackball = true;
  settings.zoom_to_cursor = false;
  settings.invert_wheel = true;
  settings.orbit_selection = true;
  settings.refine_on_surface = false;
  settings.snaps = {false, false, true, true, true, true, true, true, false, true};
  settings.environment = {EnvironmentKind::file, "/panoramas/hall.hdr", 120, -2.5};
  settings.orbit_speed = 0.3;
  settings.zoom_speed = 2.5;
  settings.autosave_seconds = 7;
  settings.keys = {{"view.frame_all", "F9"}, {"edit.undo", ""}};
  settings.side_width = 401;
  settings.objects_height = 333;
  return settings;
}

ExportMemory exports() {
  ExportMemory memory;
  ExportSettings& stl = memory.formats[".stl"];
  stl.distance = 0.02;
  stl.angle = 0.1;
  stl.optimise = true;
  stl.choices = {Unit::inch, 2.5, true, true};
  ExportSettings& ply = memory.formats[".ply"];
  ply.by = ExportSettings::By::density;
  ply.density = 40;
  memory.cad = {1e-4, 0.002, CadQuality::fine, true, true, Unit::metre, 2.5, true};
  memory.picture = {PictureSettings::Size::custom, {640, 480}, true, false, true, false, 12, false};
  memory.drawing = {99.5, false, true};
  memory.folders = {{"import", "/models"}, {"cad", "/out"}};
  return memory;
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
  ASSERT_TRUE(SettingsFile(path_).save(unusual(), exports()).ok());
  const auto loaded = load();
  EXPECT_TRUE(loaded.problems.empty());
  EXPECT_EQ(loaded.settings, unusual());
  EXPECT_EQ(loaded.exports, exports());
  EXPECT_EQ(settings_of(settings_text(unusual())), unusual());
  EXPECT_EQ(settings_of("no json"), Settings{});
}

TEST_F(SettingsFileTest, WrongValuesHaveTheirDefaultsAndAreNamed) {
  fs::create_directories(path_.parent_path());
  test::spill(path_, R"({"theme": "pink", "autosave_seconds": 1000, "trackball": 1, "orbit_speed": "fast",
                         "keys": {"edit.undo": 3, "edit.redo": "F8"}, "zoom_speed": 2,
                         "exports": {"stl": {"scale": -1, "density": 9}, "xyz": {"scale": -1}, "cad": 3,
                                     "folders": {"import": 4, "pages": "/paper"}}})");
  const auto loaded = load();
  ASSERT_EQ(loaded.problems.size(), 1U);
  EXPECT_EQ(loaded.problems[0].code, w_settings_value);
  for (const char* name : {"theme", "autosave_seconds", "trackball", "orbit_speed", "keys.edit.undo",
                           "exports.stl.scale", "exports.cad", "exports.folders.import"})
    EXPECT_NE(loaded.problems[0].text.find(name), std::string::npos) << name;
  Settings expected;
  expected.zoom_speed = 2;
  expected.keys = {{"edit.redo", "F8"}};
  EXPECT_EQ(loaded.settings, expected);
  ExportMemory exports;
  exports.formats[".stl"].density = 9;
  exports.folders = {{"pages", "/paper"}};
  EXPECT_EQ(loaded.exports, exports);
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
  test::spill(path_, R"({"of_a_later_version": [1, {"a": 2}], "theme": "light",
                         "exports": {"xyz": {"b": 3}, "stl": {"of_a_later_version": 4}}})");
  SettingsFile file(path_);
  Settings settings = file.load().settings;
  EXPECT_EQ(settings.theme, ThemeId::light);
  settings.theme = ThemeId::dark;
  ASSERT_TRUE(file.save(settings, exports()).ok());
  ASSERT_TRUE(file.save(settings, {}).ok());
  const std::string text = test::slurp(path_);
  EXPECT_NE(text.find("of_a_later_version"), text.rfind("of_a_later_version"));
  EXPECT_NE(text.find("xyz"), std::string::npos);
  EXPECT_EQ(load().settings.theme, ThemeId::dark);
  ExportMemory kept = exports();
  kept.picture = {};
  kept.drawing = {};
  kept.folders = {};
  EXPECT_EQ(load().exports, kept) << "formats that were not chosen again";
}

TEST_F(SettingsFileTest, ADeepFileIsPutAside) {
  fs::create_directories(path_.parent_path());
  test::spill(path_,
              R"({"of_a_later_version": )" + std::string(400'000, '[') + std::string(400'000, ']') + "}");
  SettingsFile file(path_);
  const auto loaded = file.load();
  ASSERT_EQ(loaded.problems.size(), 1U);
  EXPECT_EQ(loaded.problems[0].code, w_settings_broken);
  EXPECT_TRUE(file.save(unusual(), exports()).ok());
  EXPECT_EQ(load().exports, exports());
}

/// Text with a few bytes changed, left out or repeated.
std::string damaged(std::string text, std::mt19937_64& rng) {
  for (int changes = test::uniform_int(rng, 1, 6); changes > 0 && !text.empty(); --changes) {
    const auto at = std::size_t(test::uniform_int(rng, 0, int(text.size()) - 1));
    const auto length = std::size_t(test::uniform_int(rng, 1, 40));
    switch (test::uniform_int(rng, 0, 3)) {
      case 0:
        text[at] = char(test::uniform_int(rng, 0, 255));
        break;
      case 1:
        text[at] = "0123456789-e.\"{}[]:,"[test::uniform_int(rng, 0, 19)];
        break;
      case 2:
        text.erase(at, length);
        break;
      default:
        text.insert(at, text.substr(at, length));
    }
  }
  return text;
}

TEST_F(SettingsFileTest, NothingInTheFileKeepsTheProgramFromStarting) {
  ASSERT_TRUE(SettingsFile(path_).save(unusual(), exports()).ok());
  const std::string whole = test::slurp(path_);
  EXPECT_TRUE(load().problems.empty());
  int refused = 0;
  test::for_random(61, 50, [&](std::mt19937_64& rng) {
    test::spill(path_, damaged(whole, rng));
    SettingsFile file(path_);
    const auto loaded = file.load();
    refused += !loaded.problems.empty();
    for (const auto& [ending, settings] : loaded.exports.formats) {
      EXPECT_TRUE(settings.distance >= 0 && std::isfinite(settings.distance)) << ending;
      EXPECT_TRUE(settings.density >= 1 && settings.density <= 64) << ending;
      EXPECT_TRUE(settings.choices.scale >= 1e-6 && settings.choices.scale <= 1e6) << ending;
    }
    EXPECT_TRUE(loaded.exports.cad.tolerance >= 0 && loaded.exports.cad.scale > 0);
    EXPECT_TRUE(loaded.exports.picture.custom.width >= 1 && loaded.exports.picture.turntable_pictures >= 1);
    EXPECT_TRUE(loaded.exports.drawing.width >= 10 && loaded.exports.drawing.width <= 2000);
    ASSERT_TRUE(file.save(unusual(), exports()).ok());
    EXPECT_EQ(load().settings, unusual());
    EXPECT_EQ(load().exports.cad, exports().cad);
  });
  EXPECT_GT(refused, 0);
}

TEST_F(SettingsFileTest, AFileThatCannotBeReadOrWrittenSaysSo) {
  test::spill(folder_.path() / "config", "a file where the folder should be");
  EXPECT_FALSE(SettingsFile(path_).save({}, {}).ok());
  fs::remove(folder_.path() / "config");
  fs::create_directories(path_);  // a folder where the file should be
  const auto loaded = load();
  EXPECT_EQ(loaded.problems.size(), 1U);
  EXPECT_EQ(loaded.settings, Settings{});
}

}  // namespace
}  // namespace hariko

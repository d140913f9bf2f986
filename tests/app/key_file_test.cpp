// Key files: what was exported comes back, and nothing else is taken for keys.

#include "ui/files/key_file.hpp"

#include <gtest/gtest.h>

#include "ui/editor/command_table.hpp"

namespace hariko {
namespace {

TEST(KeyFile, BringsBackWhatWasWritten) {
  for (const KeyOverrides& keys :
       {KeyOverrides{}, KeyOverrides{{"mesh.knife", "F8"}, {"shape.crease", ""}},
        KeyOverrides{{"edit.redo", "Ctrl+Shift+Z / Ctrl+Y"}, {"a \"quoted\" \\ name", "\u00e9"}}}) {
    const auto back = read_key_file(write_key_file(keys));
    ASSERT_TRUE(back.ok()) << back.error().text;
    EXPECT_EQ(*back, keys);
  }
}

TEST(KeyFile, RefusesEverythingElseWithAReason) {
  const std::string good = write_key_file({{"mesh.knife", "F8"}});
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"),
        std::string("{\"keys\": {\"mesh.knife\": \"F8\"}}"),
        std::string(R"({"format": "hariko-keys", "version": 2, "keys": {}})"),
        std::string(R"({"format": "hariko-keys", "version": 1})"),
        std::string(R"({"format": "hariko-keys", "version": 1, "keys": [1]})"),
        std::string(R"({"format": "hariko-keys", "version": 1, "keys": {"mesh.knife": 8}})"),
        good.substr(0, good.size() / 2)}) {
    const auto read = read_key_file(text);
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_EQ(read.error().code, e_key_file) << text;
    EXPECT_FALSE(read.error().remedy.empty()) << text;
  }
}

TEST(KeyFile, KeysOfChangedIdsStayWithTheirCommands) {
  const auto read = read_key_file(write_key_file({{"property.preferences.turning", "Ctrl+Alt+T"},
                                                  {"property.preferences.colours", "Ctrl+Alt+C"},
                                                  {"property.preferences.colour_blind_maps", "Ctrl+Alt+M"},
                                                  {"help.japanese", "Ctrl+Alt+J"},
                                                  {"edit.undo", "Ctrl+Z"}}));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(*read, (KeyOverrides{{"property.preferences.trackball", "Ctrl+Alt+T"},
                                 {"language.japanese", "Ctrl+Alt+J"},
                                 {"property.preferences.colour_blind_maps", "Ctrl+Alt+M"},
                                 {"edit.undo", "Ctrl+Z"}}));
}

}  // namespace
}  // namespace hariko

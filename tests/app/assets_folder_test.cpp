// The program's data are found from where it lies, in any prefix.

#include "app/assets_folder.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "app/window/gl_window.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

class AssetsFolder : public ::testing::Test {
 protected:
  fs::path top() const { return folder_.path(); }
  fs::path installed(const std::string& prefix) const {
    const fs::path data = top() / prefix / "share" / "hariko";
    fs::create_directories(data / "samples");
    return data;
  }
  fs::path found(const fs::path& program, std::map<std::string, std::string> variables = {}) const {
    // The test does not depend on what this machine has installed.
    variables.emplace("XDG_DATA_DIRS", (top() / "nothing").string());
    return assets_folder(program, [&](const char* name) {
      const auto it = variables.find(name);
      return it == variables.end() ? nullptr : it->second.c_str();
    });
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(AssetsFolder, LiesBesideTheProgramInAnyPrefix) {
  for (const std::string prefix : {"usr", "opt/hariko 0.1", "home/ada/.local"}) {
    const fs::path data = installed(prefix);
    EXPECT_EQ(found(top() / prefix / "bin" / "hariko"), data);
    EXPECT_EQ(found(top() / prefix / "games" / "hariko (deleted)"), data) << "replaced while it runs";
  }
}

TEST_F(AssetsFolder, IsTheOneThatTheUserNames) {
  installed("usr");
  const fs::path own = top() / "own";
  EXPECT_EQ(found(top() / "usr/bin/hariko", {{"HARIKO_ASSETS", own.string()}}), own);
  EXPECT_EQ(found(top() / "usr/bin/hariko", {{"HARIKO_ASSETS", ""}}), top() / "usr/share/hariko");
}

TEST_F(AssetsFolder, OfACopiedProgramIsAmongTheDataOfTheSystem) {
  const fs::path data = installed("usr");
  const std::string folders = "relative/share::" + (top() / "empty/share").string() + ":" +
                              (top() / "usr/share").string() + ":" + (top() / "nothing").string();
  EXPECT_EQ(found(top() / "copied/hariko", {{"XDG_DATA_DIRS", folders}}), data);
}

TEST_F(AssetsFolder, OfItsOwnPrefixComesFirst) {
  const fs::path data = installed("opt"), other = installed("usr");
  EXPECT_EQ(found(top() / "opt/bin/hariko", {{"XDG_DATA_DIRS", (top() / "usr/share").string()}}), data);
}

TEST_F(AssetsFolder, IsSoughtBesideTheProgramWhereThereIsNone) {
  EXPECT_EQ(found(top() / "opt/bin/hariko"), top() / "opt/share/hariko");
}

TEST(WindowIcons, ComeInTheSizesOfTheirFolders) {
  const std::vector<Image> icons = window_icons(icons_folder(fs::path(test::source_folder()) / "assets/x"));
  ASSERT_EQ(icons.size(), 6U);
  for (const Image& icon : icons) {
    EXPECT_EQ(icon.width, icon.height);
    // The corners are free, the middle is drawn.
    EXPECT_EQ(icon.pixel(0, 0)[3], 0) << icon.width;
    EXPECT_EQ(icon.pixel(icon.width / 2, icon.height / 2)[3], 255) << icon.width;
  }
  EXPECT_EQ(icons.front().width, 16);
  EXPECT_EQ(icons.back().width, 128);
  EXPECT_TRUE(window_icons("/nowhere").empty());
}

}  // namespace
}  // namespace hariko

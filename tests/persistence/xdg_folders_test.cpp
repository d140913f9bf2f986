#include "app/persistence/xdg_folders.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace hariko {
namespace {

XdgFolders with(const std::map<std::string, std::string>& variables) {
  return xdg_folders([&](const char* name) {
    const auto it = variables.find(name);
    return it == variables.end() ? nullptr : it->second.c_str();
  });
}

TEST(XdgFolders, FollowsTheVariables) {
  const XdgFolders folders = with(
      {{"XDG_CONFIG_HOME", "/c"}, {"XDG_STATE_HOME", "/s"}, {"XDG_CACHE_HOME", "/x"}, {"HOME", "/home/ada"}});
  EXPECT_EQ(folders.config, "/c/hariko");
  EXPECT_EQ(folders.state, "/s/hariko");
  EXPECT_EQ(folders.cache, "/x/hariko");
}

TEST(XdgFolders, FallsBackToTheHomeFolder) {
  for (const char* useless : {"", "relative/folder"}) {
    const XdgFolders folders = with({{"HOME", "/home/ada"}, {"XDG_STATE_HOME", useless}});
    EXPECT_EQ(folders.config, "/home/ada/.config/hariko");
    EXPECT_EQ(folders.state, "/home/ada/.local/state/hariko");
    EXPECT_EQ(folders.cache, "/home/ada/.cache/hariko");
  }
}

TEST(XdgFolders, AreAbsoluteWithoutAnyVariable) {
  const XdgFolders folders = with({});
  EXPECT_TRUE(folders.config.is_absolute() && folders.state.is_absolute() && folders.cache.is_absolute());
}

}  // namespace
}  // namespace hariko

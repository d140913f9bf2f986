#include "app/persistence/xdg_folders.hpp"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace hariko {

namespace fs = std::filesystem;

namespace {

fs::path absolute_or_nothing(const char* text) {
  const fs::path path = text ? text : "";
  return path.is_absolute() ? path : fs::path();
}

fs::path home_folder(const EnvironmentLookup& environment) {
  if (fs::path home = absolute_or_nothing(environment("HOME")); !home.empty()) return home;
  const passwd* entry = ::getpwuid(::getuid());
  if (fs::path home = absolute_or_nothing(entry ? entry->pw_dir : nullptr); !home.empty()) return home;
  std::error_code error;
  const fs::path temporary = fs::temp_directory_path(error);
  return (error ? fs::path("/tmp") : temporary) / ("hariko-" + std::to_string(::getuid()));
}

}  // namespace

XdgFolders xdg_folders(const EnvironmentLookup& environment) {
  const auto folder = [&](const char* variable, const char* below_home) {
    const fs::path given = absolute_or_nothing(environment(variable));
    return (given.empty() ? home_folder(environment) / below_home : given) / "hariko";
  };
  return {folder("XDG_CONFIG_HOME", ".config"), folder("XDG_STATE_HOME", ".local/state"),
          folder("XDG_CACHE_HOME", ".cache")};
}

XdgFolders xdg_folders() {
  return xdg_folders([](const char* name) { return std::getenv(name); });
}

}  // namespace hariko

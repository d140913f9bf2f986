#include "app/assets_folder.hpp"

#include <cstdlib>
#include <string_view>

namespace hariko {

namespace fs = std::filesystem;

namespace {

bool has_samples(const fs::path& folder) {
  std::error_code unknown;
  return fs::is_directory(folder / "samples", unknown);
}

}  // namespace

fs::path assets_folder(const fs::path& program, const EnvironmentLookup& environment) {
  if (const char* given = environment("HARIKO_ASSETS"); given && *given) return given;
  const fs::path beside = program.parent_path().parent_path() / "share" / "hariko";
  if (has_samples(beside)) return beside;
  const char* set = environment("XDG_DATA_DIRS");
  std::string_view folders = set && *set ? set : "/usr/local/share:/usr/share";
  while (!folders.empty()) {
    const std::size_t colon = folders.find(':');
    const fs::path folder = fs::path(folders.substr(0, colon)) / "hariko";
    // The specification requires absolute paths.
    if (folder.is_absolute() && has_samples(folder)) return folder;
    folders = colon == std::string_view::npos ? std::string_view() : folders.substr(colon + 1);
  }
  return beside;
}

fs::path assets_folder() {
  std::error_code unknown;
  return assets_folder(fs::read_symlink("/proc/self/exe", unknown),
                       [](const char* name) { return std::getenv(name); });
}

fs::path icons_folder(const fs::path& assets) {
  return assets.parent_path() / "icons";
}

}  // namespace hariko

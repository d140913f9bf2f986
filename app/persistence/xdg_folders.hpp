#pragma once

// XdgFolders: folders for data that are not the user's documents (XDG Base Directory Specification 0.8).

#include <filesystem>
#include <functional>

namespace hariko {

/// Folders of this program; they need not exist.
struct XdgFolders {
  std::filesystem::path config;  ///< settings
  std::filesystem::path state;   ///< recovery copies, recent files
  std::filesystem::path cache;   ///< pictures, which can be made again
};

using EnvironmentLookup = std::function<const char*(const char*)>;

/// Folders $XDG_CONFIG_HOME/hariko, $XDG_STATE_HOME/hariko and $XDG_CACHE_HOME/hariko; where a variable is
/// unset or not an absolute path, which the specification requires, ~/.config, ~/.local/state and ~/.cache.
/// Without $HOME the home folder of the password database is used, and without that the folder for temporary
/// files.
XdgFolders xdg_folders(const EnvironmentLookup& environment);
/// Folders for the program's environment.
XdgFolders xdg_folders();

}  // namespace hariko

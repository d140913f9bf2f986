#pragma once

// XdgFolders: where the program keeps what is not the user's documents (XDG Base Directory Specification
// 0.8).

#include <filesystem>
#include <functional>

namespace hariko {

/// Folders of this program; they need not exist.
struct XdgFolders {
  std::filesystem::path config;  ///< settings
  std::filesystem::path state;   ///< recovery copies, recent files
  std::filesystem::path cache;   ///< pictures that can be made again
};

using EnvironmentLookup = std::function<const char*(const char*)>;

/// $XDG_CONFIG_HOME/hariko, $XDG_STATE_HOME/hariko and $XDG_CACHE_HOME/hariko; where a variable is unset or
/// not an absolute path, as the specification demands, ~/.config, ~/.local/state and ~/.cache. Without $HOME
/// the user's entry in the password database counts, and without that the folder for temporary files.
XdgFolders xdg_folders(const EnvironmentLookup& environment);
XdgFolders xdg_folders();

}  // namespace hariko

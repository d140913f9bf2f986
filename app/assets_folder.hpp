#pragma once

// Folders of the program's data: samples, languages, pictures and icons.

#include <filesystem>

#include "app/persistence/xdg_folders.hpp"

namespace hariko {

/// Folder with "samples" and "languages": $HARIKO_ASSETS where it is set; else ../share/hariko relative to
/// the folder of `program`, an absolute path without symbolic links (a build folder has the layout of an
/// installed prefix); where that is no folder, the first "hariko" in $XDG_DATA_DIRS
/// (/usr/local/share:/usr/share) that has samples, for a program that was copied out of its prefix. Without
/// any of these the folder beside the program.
std::filesystem::path assets_folder(const std::filesystem::path& program,
                                    const EnvironmentLookup& environment);
/// Assets folder of the running program.
std::filesystem::path assets_folder();

/// Folder with the icon theme "hicolor" for these assets; it need not exist.
std::filesystem::path icons_folder(const std::filesystem::path& assets);

}  // namespace hariko

#pragma once

// Folders of the program's data: samples, languages, pictures, icons.

#include <filesystem>

#include "app/persistence/xdg_folders.hpp"

namespace hariko {

/// The folder with "samples" and "languages". $HARIKO_ASSETS where it is set; else ../share/hariko seen from
/// the folder of `program`, an absolute path without symbolic links (a build folder has the same layout as an
/// installed prefix); where that is no folder, the first "hariko" in $XDG_DATA_DIRS
/// (/usr/local/share:/usr/share) that has samples, for a program that was copied out of its prefix. The
/// folder beside the program where there is none at all.
std::filesystem::path assets_folder(const std::filesystem::path& program,
                                    const EnvironmentLookup& environment);
/// That of the running program.
std::filesystem::path assets_folder();

/// The folder with the theme "hicolor" that goes with these assets; need not exist.
std::filesystem::path icons_folder(const std::filesystem::path& assets);

}  // namespace hariko

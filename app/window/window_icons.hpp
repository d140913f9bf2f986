#pragma once

// Icons of the program's window.

#include <filesystem>
#include <vector>

#include "render/image.hpp"

namespace hariko {

/// Those of the theme in `icons`/hicolor in the sizes that title bars, task bars and switchers show; none
/// where they are not there, and then desktops take the one of the menu entry.
std::vector<Image> window_icons(const std::filesystem::path& icons);

}  // namespace hariko

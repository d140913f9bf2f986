#pragma once

// Icons of the program's window.

#include <filesystem>
#include <vector>

#include "render/image.hpp"

namespace hariko {

/// Icons of the theme in `icons`/hicolor, in the sizes of title bars, task bars and switchers; empty where
/// they do not exist, in which case desktops use the menu entry's icon.
std::vector<Image> window_icons(const std::filesystem::path& icons);

}  // namespace hariko

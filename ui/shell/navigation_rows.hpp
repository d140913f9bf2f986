#pragma once

// What the buttons of the mouse do to the view, in words, for the preferences and the cheat sheet.

#include <string>
#include <utility>
#include <vector>

#include "ui/base/language.hpp"
#include "ui/base/settings.hpp"

namespace hariko {

/// "Orbit" with "Middle drag, Alt + left drag", and so on, in the language given.
std::vector<std::pair<std::string, std::string>> navigation_rows(const Language& tr, NavigationPreset preset);

}  // namespace hariko

#pragma once

// Question for the name of a saved view, and for the focal length.

#include <string>

#include "ui/editor/editor.hpp"
#include "ui/widgets/command_services.hpp"

namespace hariko {

/// Asks for another name of a saved view and gives it.
void ask_view_name(Editor& editor, CommandServices& services, const std::string& name);
/// Asks for the focal length of the active view and sets it.
void ask_focal_length(Editor& editor, CommandServices& services);

}  // namespace hariko

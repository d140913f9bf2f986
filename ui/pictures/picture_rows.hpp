#pragma once

// The properties of reference pictures.

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// How the chosen pictures show, and where their files are. Draws nothing for other objects.
void picture_section(PanelContext& context, const Objects& objects);

}  // namespace hariko

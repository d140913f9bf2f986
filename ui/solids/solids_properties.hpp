#pragma once

// Part of the properties: solids and the surface round them.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Of an object made of solids: the selected ones, the list of all, and the settings of the surface.
void draw_solids(PanelContext& context, const Object& object);

}  // namespace hariko

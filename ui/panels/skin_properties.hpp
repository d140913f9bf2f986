#pragma once

// Part of the properties: how the active skin is made, and its selected points.

#include "ui/panels/panels.hpp"

namespace hariko {

/// Nothing where the active object is no skin.
void draw_skin_properties(PanelContext& context);

}  // namespace hariko

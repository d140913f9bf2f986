#pragma once

// Part of the properties: how the active skin is made, and its selected points.

#include "ui/panels/panels.hpp"

namespace hariko {

/// Nothing where the active object is no skin.
void draw_skin_properties(PanelContext& context);

/// A button that does what the remedy of a skin's message says, where one click can.
void draw_skin_fix(PanelContext& context, const Object& object, const SurfaceView& view);

}  // namespace hariko

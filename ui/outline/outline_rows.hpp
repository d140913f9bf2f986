#pragma once

// The properties of an outline: how its surface is found, and its selected points.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// How the surface inside is found, and what came out. Draws nothing for other objects.
void outline_section(PanelContext& context, const Object& object);

/// Tilt and position of the selected points of the active outline; nothing where none are.
void outline_point_section(PanelContext& context);

/// What can be done at once about the error of an outline's surface.
void draw_outline_fix(PanelContext& context, const Object& object, const Message& error);

}  // namespace hariko

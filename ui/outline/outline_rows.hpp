#pragma once

// The properties of an outline: how its surface is found, and its selected points.

#include <vector>

#include "ui/widgets/panel_row.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

/// Section of how the surface inside is found, and what came out. Draws nothing for other objects.
void outline_section(PanelContext& context, const Object& object);

/// Properties of how densely points are inserted.
ObjectProperties<OutlineSettings> outline_properties();

/// Rows of an outline and of its selected points.
std::vector<PanelRow> outline_panel_rows();

/// Tilt and position of the selected points of the active outline; nothing where none are.
void outline_point_section(PanelContext& context);

/// Fixes at hand for the error of an outline's surface.
void draw_outline_fix(PanelContext& context, const Object& object, const Message& error);

}  // namespace hariko

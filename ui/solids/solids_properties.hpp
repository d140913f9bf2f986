#pragma once

// Part of the properties: solids and the surface round them.

#include <vector>

#include "ui/widgets/panel_row.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

/// Section of an object made of solids: the selected ones, the list of all, and the settings of the surface.
/// Draws nothing for other objects.
void draw_solids(PanelContext& context, const Object& object);

/// Rows of the selected solids.
std::vector<PanelRow> solid_panel_rows();

/// Properties of the surface.
ObjectProperties<EnvelopeInput> envelope_properties();

}  // namespace hariko

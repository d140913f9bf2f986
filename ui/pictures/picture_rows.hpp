#pragma once

// The properties of reference pictures.

#include <vector>

#include "ui/editor/selected_items.hpp"
#include "ui/view/tool.hpp"
#include "ui/widgets/panel_row.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

/// Look of the chosen pictures, and where their files are. Draws nothing for other objects.
void picture_section(PanelContext& context, const Objects& objects);

/// Rows of a picture.
std::vector<PanelRow> picture_panel_rows();

/// Properties of how a picture shows, but for the views that show it.
ObjectProperties<PictureLook> picture_properties();

/// Modal, for the active picture: two clicks on it, then the distance is typed and Enter makes one step.
/// Backspace without a number takes the second point back. Esc or a right click leaves all as it was.
std::unique_ptr<Tool> make_picture_scale_tool(ObjectId picture);

}  // namespace hariko

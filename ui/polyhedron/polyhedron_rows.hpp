#pragma once

// Part of the properties: rows about polyhedra as a whole. They draw nothing for other objects.

#include <vector>

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panel_row.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

class PropertyScripts;

/// The list of the modes of surfaces.
void polyhedron_mode_row(PanelContext& context, const Objects& objects);
/// The live mirror: its plane, and making the image the object's own.
void live_mirror_row(PanelContext& context, const Objects& objects);
/// Hint on setting tensions, for while nothing is selected.
void tension_hint(PanelContext& context, const Object& object);

/// Rows of a polyhedron and of its selected elements.
std::vector<PanelRow> polyhedron_panel_rows();
/// Adds the mode and the live mirror. The table and the editor must outlive what is added.
void add_polyhedron_scripts(PropertyScripts& scripts, CommandTable& table, Editor& editor);

ObjectProperties<Preparation> preparation_properties();

/// Offers to split concave faces where warnings of a polyhedron's surface name them.
void draw_concave_fix(PanelContext& context, const Object& object, const std::vector<Message>& warnings);

}  // namespace hariko

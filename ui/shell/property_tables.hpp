#pragma once

// All tables of properties, for the commands that name them and the scripts that set them.

#include "ui/analysis/display_panel.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/outline/outline_rows.hpp"
#include "ui/pictures/picture_rows.hpp"
#include "ui/polyhedron/polyhedron_rows.hpp"
#include "ui/skin/skin_properties.hpp"
#include "ui/solids/solids_properties.hpp"
#include "ui/widgets/panel_row.hpp"

namespace hariko {

/// Calls visit(kind of objects, table) for each; an empty kind stands for all objects.
template <class Visit>
void visit_properties(const Visit& visit) {
  visit("", display_properties());
  visit(translatable("Polyhedron"), preparation_properties());
  visit(translatable("Polyhedron"), polyhedron_display_properties());
  visit(translatable("Solids"), envelope_properties());
  visit(translatable("Skin"), skin_properties());
  visit(translatable("Outline"), outline_properties());
  visit(translatable("Reference picture"), picture_properties());
}

/// All of them.
std::vector<PanelRow> panel_rows();
/// Those about what belongs to no object.
std::vector<PanelRow> panel_rows_of_document();

/// Gives the commands on properties their uses in scripts: values for all chosen objects that have the
/// property, as one step. Words are those of the file format. The host must outlive the table.
void use_properties_in_scripts(CommandHost& host);

}  // namespace hariko

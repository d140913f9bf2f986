#pragma once

// Part of the properties: how the active skin is made, and its selected points.

#include <functional>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "ui/widgets/panel_row.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

class PropertyScripts;

/// Nothing where the active object is no skin.
void draw_skin_properties(PanelContext& context);

/// Rows of a skin and of its selected points.
std::vector<PanelRow> skin_panel_rows();
/// Adds frames, and closed sections and paths.
void add_skin_scripts(PropertyScripts& scripts);

/// Properties of a skin but for what an edit of its sections or its path changes.
ObjectProperties<Skin> skin_properties();

/// A choice of one of the lists, by what it is called.
struct SkinChoice {
  std::string id;                   ///< "skin_frame.3"
  const char *list, *label, *help;  ///< English; the list is what its row is called
  std::function<void(Editor&, const Object&)> choose;
};
/// Those of the lists that every skin has.
std::vector<SkinChoice> skin_choices();

/// A button that does what the remedy of a skin's message says, where one click can.
void draw_skin_fix(PanelContext& context, const Object& object, const SurfaceView& view);

/// A row a section with its largest distance, from the surface that was made last, or one for all where the
/// surface goes through all; nothing where there is no surface. Marks: "skin.miss.<number>", "skin.miss.all".
void draw_section_rows(PanelContext& context, const Object& object);

}  // namespace hariko

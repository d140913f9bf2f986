#pragma once

// The part of the properties about how an object is seen: what is shown of it and in which colours belongs to
// the document, how one looks at it (stripes, section, tolerances) to the view.

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panels.hpp"
#include "ui/widgets/property.hpp"

namespace hariko {

/// Draws the rows into the current panel: what all objects have in common, mixed where they differ.
/// `objects`: at least one, the active one first.
void draw_display(PanelContext& context, const Objects& objects);

/// Properties of the display of all objects, and of polyhedra alone.
ObjectProperties<DisplaySettings> display_properties();
ObjectProperties<DisplaySettings> polyhedron_display_properties();

/// Draws the rows of a map of making: pull, limit, reference. They are of the document, for all objects.
void making_rows(PanelContext& context, SurfaceMap map);

/// A sentence where the active object should show a map of making and cannot.
void missing_map_row(PanelContext& context);

/// Draws the rows of the environment: which one, its file, its turn about z and its exposure. They change the
/// settings, not the document.
void environment_rows(PanelContext& context);

/// The switch, and while it is on the planes and the combs.
void section_curve_rows(PanelContext& context);

}  // namespace hariko

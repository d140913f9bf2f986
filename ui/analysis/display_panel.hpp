#pragma once

// The part of the properties about how an object is seen: what is shown of it and in which colours belongs to
// the document, how one looks at it (stripes, section, tolerances) to the view.

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Draws the rows into the current panel: what all objects have in common, mixed where they differ.
/// `objects`: at least one, the active one first.
void draw_display(PanelContext& context, const Objects& objects);

}  // namespace hariko

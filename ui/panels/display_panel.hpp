#pragma once

// The part of the properties about how an object is seen: what is shown of it and in which colours belongs to
// the document, how one looks at it (stripes, section, tolerances) to the view.

#include "ui/panels/panels.hpp"

namespace hariko {

/// Draws the rows into the current panel. `object` is the active one.
void draw_display(PanelContext& context, const Object& object);

}  // namespace hariko

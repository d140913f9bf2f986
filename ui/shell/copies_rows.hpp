#pragma once

// The properties of live copies.

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Number of places that the objects have and, where they are in a row or a ring, how far these are from each
/// other, or where the plane of a mirror image is. Fields change the outermost array of each object. Draws
/// nothing unless all objects have live copies.
void copies_rows(PanelContext& context, const Objects& objects);

}  // namespace hariko

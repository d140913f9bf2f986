#pragma once

// Rows of the properties: how selected border edges are joined to patches.

#include "ui/editor/selected_items.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Nothing where none of the edges is attached.
void attachment_rows(PanelContext& context, const SelectedIds<EdgeId>& selected);

}  // namespace hariko

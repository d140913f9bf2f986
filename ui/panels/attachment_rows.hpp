#pragma once

// Rows of the properties: how selected border edges are joined to patches.

#include "ui/panels/panels.hpp"
#include "ui/panels/selected_items.hpp"

namespace hariko {

/// Nothing where none of the edges is attached.
void attachment_rows(PanelContext& context, const SelectedIds<EdgeId>& selected);

}  // namespace hariko

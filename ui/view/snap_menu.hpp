#pragma once

// SnapMenu: the button beside a view's title, with what drawings and drags snap to and where they draw.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// The button right of what stands at `title`; call before items that lie under it. A click opens
/// the menu. Gives true where the pointer is on it. Nothing in views that have no room for it.
bool snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane);
/// Draws the button, over the picture, and the menu while it is open.
void draw_snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                      bool hovered);

}  // namespace hariko

#pragma once

// ViewsMenu: the button beside a view's title, with the saved views and the lens.

#include "ui/widgets/panels.hpp"

namespace hariko {

/// Place of the button right of the title; in views that have no room for it that of the title itself. What
/// stands further to the right begins at its end.
PanelRect views_button_place(const PanelContext& context, const PanelRect& title, const PanelRect& pane);
/// The button; call before items that lie under it. A click opens the menu. Gives true where the pointer is
/// on it.
bool views_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane);
/// Draws the button, over the picture, and the menu while it is open.
void draw_views_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                       bool hovered);

}  // namespace hariko

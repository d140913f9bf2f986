#pragma once

// ViewsMenu and SnapMenu: buttons beside a view's title. One has the saved views and the lens, the other what
// drawings and drags snap to and where they draw.

#include <string>

#include "ui/editor/editor.hpp"
#include "ui/widgets/command_services.hpp"
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

/// The button right of what stands at `title`; call before items that lie under it. A click opens
/// the menu. Gives true where the pointer is on it. Nothing in views that have no room for it.
bool snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane);
/// Draws the button, over the picture, and the menu while it is open.
void draw_snap_button(PanelContext& context, int view, const PanelRect& title, const PanelRect& pane,
                      bool hovered);

/// Asks for another name of a saved view and gives it.
void ask_view_name(Editor& editor, CommandServices& services, const std::string& name);
/// Asks for the focal length of the active view and sets it.
void ask_focal_length(Editor& editor, CommandServices& services);

}  // namespace hariko

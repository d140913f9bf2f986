#pragma once

// Frame of a view's picture: its title with a menu, the scale bar, the border of the active view.

#include "ui/editor/probe.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Title of a view, by what it shows: "Top", "Perspective".
const char* title_of(const Camera& camera);

/// Place of the title.
PanelRect view_title_place(const PanelContext& context, int view, const PanelRect& pane);
/// The clickable title in the upper left corner; call before items that lie under it. A click opens the
/// view's menu, a double click maximises the view or shows all again. Gives true where the pointer is on it.
bool view_title_button(PanelContext& context, int view, const PanelRect& pane);
/// Draws the title, over the picture, and the menu while it is open.
void draw_view_title(PanelContext& context, int view, const PanelRect& pane, bool hovered);

/// A button of a view with a menu of a kind, "snaps", whose popup is then called "snaps.0". Marked
/// "view.0.snaps". A click opens the menu. Gives true where the pointer is on it.
bool view_menu_button(PanelContext& context, int view, const PanelRect& place, const std::string& kind);
/// Draws such a button, over the picture, and its menu below, which is open or not.
[[nodiscard]] OpenScope view_menu(const PanelContext& context, const PanelRect& place, const char* text,
                                  ImU32 colour, const std::string& popup);

/// A length that reads well (1, 2 or 5 times a power of ten) and is at most `longest`, which is > 0.
double scale_bar_length(double longest);
/// Numbers at the lower and left borders of a side view's grid, in the document's unit.
void draw_grid_labels(const PanelContext& context, const Camera& camera, const PanelRect& pane,
                      const GridSettings& grid);
/// At the lower right, for lengths in the plane of the camera's target.
void draw_scale_bar(const PanelContext& context, const Camera& camera, const PanelRect& pane);

/// Probe of the surface under the pointer, while it shows a map, and at Editor::kept_probe.
void draw_probe(PanelContext& context, const Camera& camera, PixelSize size, const PanelRect& pane,
                const std::optional<SurfacePoint>& under_pointer);

/// The shares of the last frames, while Editor::frame_times is visible.
void draw_frame_overlay(const PanelContext& context, const PanelRect& pane);

}  // namespace hariko

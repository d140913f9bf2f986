#pragma once

// ViewPanes: where the views stand in the window, which of them is worked in, and the bars between them.

#include <vector>

#include "ui/editor/editor.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

class ViewPanes {
 public:
  struct Place {
    int view = 0;
    PanelRect rect;
    bool title_hovered = false, views_hovered = false, snaps_hovered = false;
    bool gizmo_hovered = false;
  };

  explicit ViewPanes(Editor& editor) : editor_(editor) {}

  /// Places the views of the editor's layout in a rectangle of the window.
  void arrange(const PanelRect& rect);
  /// The view under the pointer is the active one, unless something is being dragged (`busy`: by a tool). A
  /// pointer that only crosses a view on its way to a menu leaves the one active that was worked in.
  void activate_under_pointer(const PanelRect& rect, bool busy);
  /// Works in a view from now on.
  void activate(const Place& place);
  /// The bars between views, which change their shares of the rectangle.
  void drag_splitters(PanelContext& context, const PanelRect& rect);

  std::vector<Place>& places() { return places_; }
  const std::vector<Place>& places() const { return places_; }
  /// Rectangle of the active view, in window pixels: tools and commands act there.
  const PanelRect& rect() const { return rect_; }
  /// Framebuffer pixels from the upper left corner of the active view.
  Vector2 pixel_at(ImVec2 point) const;
  static PixelSize size_of(const Place& place);

 private:
  const Place& active_place() const;
  void use_active_place();
  void drag_splitter(PanelContext& context, const PanelRect& rect, const char* name, const PanelRect& bar,
                     ImGuiMouseCursor cursor);

  Editor& editor_;
  std::vector<Place> places_;
  PanelRect rect_{};
};

/// Whether a point of the window lies in a rectangle.
inline bool holds(const PanelRect& rect, ImVec2 point) {
  return point.x >= rect.min.x && point.x < rect.max.x && point.y >= rect.min.y && point.y < rect.max.y;
}

/// After a panel beside the views was opened (`narrower`), or before one closes. What is seen as a whole
/// stays so and fills its view again; a view that was turned to a part stays where it is.
void change_room_of_views(Editor& editor, bool narrower);

}  // namespace hariko

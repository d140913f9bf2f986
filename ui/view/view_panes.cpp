#include "ui/view/view_panes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/widgets/items.hpp"

namespace hariko {

namespace {

constexpr float gap = 2;                                  // between views
constexpr float thick_splitter = 4, middle_splitter = 9;  // design pixels

}  // namespace

void ViewPanes::arrange(const PanelRect& rect) {
  std::vector<Place> before = std::move(places_);
  places_.clear();
  for (const Pane& pane : editor_.layout.panes()) {
    Place place;
    place.view = pane.view;
    const auto at = [&](float x, float y) {
      return ImVec2(std::round(rect.min.x + x * rect.width()), std::round(rect.min.y + y * rect.height()));
    };
    place.rect = {at(pane.left, pane.top), at(pane.right, pane.bottom)};
    if (pane.left > 0) place.rect.min.x += gap / 2;
    if (pane.top > 0) place.rect.min.y += gap / 2;
    if (pane.right < 1) place.rect.max.x -= gap / 2;
    if (pane.bottom < 1) place.rect.max.y -= gap / 2;
    for (const Place& old : before) {
      if (old.view != place.view) continue;
      place.title_hovered = old.title_hovered;
      place.views_hovered = old.views_hovered;
      place.snaps_hovered = old.snaps_hovered;
      place.gizmo_hovered = old.gizmo_hovered;
    }
    places_.push_back(place);
  }
  use_active_place();
}

const ViewPanes::Place& ViewPanes::active_place() const {
  const auto found = std::ranges::find_if(
      places_, [&](const Place& place) { return place.view == editor_.layout.active(); });
  return found == places_.end() ? places_.front() : *found;
}

void ViewPanes::use_active_place() {
  rect_ = active_place().rect;
  editor_.viewport = size_of(active_place());
}

void ViewPanes::activate(const Place& place) {
  editor_.layout.activate(place.view);
  use_active_place();
}

PixelSize ViewPanes::size_of(const Place& place) {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {std::max(1, static_cast<int>(place.rect.width() * scale.x)),
          std::max(1, static_cast<int>(place.rect.height() * scale.y))};
}

Vector2 ViewPanes::pixel_at(ImVec2 point) const {
  const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
  return {double((point.x - rect_.min.x) * scale.x), double((point.y - rect_.min.y) * scale.y)};
}

void ViewPanes::activate_under_pointer(const PanelRect& rect, bool busy) {
  bool pressed = false;
  if (busy || ImGui::IsAnyMouseDown()) {
    // The press itself comes with a pointer that may have jumped here since the last frame.
    pressed = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    if (busy || !pressed) return;
  }
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  ViewLayout& layout = editor_.layout;
  if (!ImGui::IsWindowHovered() && holds(rect, mouse)) return;  // under a menu or a dialog
  layout.point_at({});
  for (const Place& place : places_) {
    if (!holds(place.rect, mouse)) continue;
    layout.point_at(place.view);
    if (pressed) layout.activate(place.view);
  }
  use_active_place();
}

void ViewPanes::drag_splitter(PanelContext& context, const PanelRect& rect, const char* name,
                              const PanelRect& bar, ImGuiMouseCursor cursor) {
  ImGui::SetCursorScreenPos(bar.min);
  if (!border_area(context.marks, name, {bar.width(), bar.height()}, cursor)) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto fraction = [](float value) {
    return std::clamp(value, ViewLayout::least_split, 1 - ViewLayout::least_split);
  };
  ViewLayout& layout = editor_.layout;
  if (cursor != ImGuiMouseCursor_ResizeNS) layout.split_x = fraction((mouse.x - rect.min.x) / rect.width());
  if (cursor != ImGuiMouseCursor_ResizeEW) layout.split_y = fraction((mouse.y - rect.min.y) / rect.height());
}

void ViewPanes::drag_splitters(PanelContext& context, const PanelRect& rect) {
  const ViewLayout& layout = editor_.layout;
  if (layout.arrangement() == Arrangement::one) return;
  const bool four = layout.arrangement() == Arrangement::four;
  const float x = rect.min.x + layout.split_x * rect.width(), y = rect.min.y + layout.split_y * rect.height();
  const float thick = context.metrics.px(thick_splitter), middle = context.metrics.px(middle_splitter);
  if (four)
    drag_splitter(context, rect, "splitter.middle", {{x - middle, y - middle}, {x + middle, y + middle}},
                  ImGuiMouseCursor_ResizeAll);
  drag_splitter(context, rect, "splitter.x", {{x - thick, rect.min.y}, {x + thick, rect.max.y}},
                ImGuiMouseCursor_ResizeEW);
  if (four)
    drag_splitter(context, rect, "splitter.y", {{rect.min.x, y - thick}, {rect.max.x, y + thick}},
                  ImGuiMouseCursor_ResizeNS);
  arrange(rect);
}

void change_room_of_views(Editor& editor, bool narrower) {
  // Half the view is left, which would cut the model off.
  if (narrower) {
    editor.wants_framing = true;
    return;
  }
  const Camera now = editor.layout.active_view().goal();
  editor.frame_all(true);
  const Camera framed = editor.layout.active_view().goal();
  editor.set_camera(now);
  constexpr double close = 1e-6;  // share of the distance
  const bool whole = std::abs(framed.distance - now.distance) <= close * now.distance &&
                     (framed.target - now.target).norm() <= close * now.distance;
  if (whole) editor.wants_framing = true;
}

}  // namespace hariko

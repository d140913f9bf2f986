#include "ui/widgets/steady_rows.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

bool within(const ImRect& panel, const Marks::Rect& rect) {
  const auto x = static_cast<float>(rect.x), y = static_cast<float>(rect.y);
  return x >= panel.Min.x && x + static_cast<float>(rect.width) <= panel.Max.x + 1 && y > panel.Min.y &&
         rect.width < static_cast<int>(panel.GetWidth());
}

/// The mark whose row is nearest to a height of the screen.
std::string nearest_row(const Marks& marks, const ImRect& panel, float y) {
  std::string nearest;
  float least = INFINITY;
  for (const auto& [name, rect] : marks.all()) {
    if (!within(panel, rect)) continue;
    const float middle = static_cast<float>(rect.y) + 0.5F * static_cast<float>(rect.height);
    const float away = std::abs(middle - y);
    if (away < least) least = away, nearest = name;
  }
  return nearest;
}

/// Whether the pointer is in a list of the panel that scrolls by itself.
bool in_scrolling_list(const ImGuiWindow& panel) {
  const ImGuiWindow* hovered = GImGui->HoveredWindow;
  return hovered && hovered != &panel && hovered->RootWindow == &panel;
}

/// Whether an item of the panel, or of a list that is open over it, is held or typed into.
bool holds_item(const ImGuiWindow& panel) {
  const ImGuiWindow* window = GImGui->ActiveId != 0 ? GImGui->ActiveIdWindow : nullptr;
  return window && window->RootWindow == &panel;
}

}  // namespace

void SteadyRows::begin() {
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + above_);
}

void SteadyRows::end(const Marks& marks, const std::string& typed) {
  ImGuiWindow& window = *GImGui->CurrentWindow;
  const ImRect panel = window.Rect();
  const bool held = holds_item(window);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (!held && !popup && !panel.Contains(mouse)) {
    *this = {};
    return;
  }
  const float above = above_, scroll = window.Scroll.y;
  const float contents = ImGui::GetCursorPosY() - above;
  if (below_ > 0) ImGui::Dummy({1, below_});
  const auto place_of = [&](const std::string& name) {
    return static_cast<float>(marks.all().at(name).y) - panel.Min.y + scroll - above;
  };
  if (row_.empty() || !marks.all().contains(row_)) {
    above_ = below_ = 0;
    row_.clear();
  } else if (const float moved = in_scrolling_list(window) ? 0 : place_of(row_) - place_;
             std::abs(moved) >= 1) {
    // Offset of the contents from the panel: below its edge, or scrolled by as much.
    const float start = above - scroll - moved;
    const float wanted = std::max(-start, 0.0F);
    above_ = std::max(start, 0.0F);
    below_ = std::max(0.0F, wanted + panel.GetHeight() - contents - above_);
    scroll_ = wanted;
    waits_ = 2;
  }
  if (waits_ > 0) {
    ImGui::SetScrollY(scroll_);
    --waits_;
  }
  // A field that is typed into stays although the pointer rests elsewhere, and so does what opened a list.
  const bool same = (popup || (held && held_ == GImGui->ActiveId)) && !row_.empty();
  held_ = GImGui->ActiveId;
  if (!typed.empty())
    row_ = typed;
  else if (!same)
    row_ = nearest_row(marks, panel, mouse.y);
  if (!row_.empty() && marks.all().contains(row_)) place_ = place_of(row_);
}

}  // namespace hariko

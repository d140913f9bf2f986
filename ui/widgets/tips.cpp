#include "ui/widgets/tips.hpp"

#include <imgui_internal.h>

#include <algorithm>

#include "ui/base/text_lines.hpp"

namespace hariko {

namespace {

// In heights of the font.
constexpr float widest_tip = 24, narrowest_tip = 9, tip_gap = 0.4F;

/// The window whose rows a tip must not cover, with the lists that are open over it.
ImRect rows_of(const ImGuiWindow& window) {
  ImRect rows = window.RootWindow->Rect();
  for (const ImGuiWindow* at = window.RootWindow; (at->Flags & ImGuiWindowFlags_Popup) && at->ParentWindow;) {
    at = at->ParentWindow->RootWindow;
    rows.Add(at->Rect());
  }
  return rows;
}

/// The menu of the last item with those that it came out of, and not the bar or the view below.
ImRect menus_of(const ImGuiWindow& window) {
  ImRect rows = window.Rect();
  for (const ImGuiWindow* at = window.ParentWindow; at && (at->Flags & ImGuiWindowFlags_Popup);
       at = at->ParentWindow)
    rows.Add(at->Rect());
  return rows;
}

/// Whether an item is held, or something was typed a moment ago. A field that merely has the keyboard, as the
/// name in a dialog has from the beginning, does not keep tips away.
bool hands_are_busy() {
  const ImGuiContext& g = *GImGui;
  constexpr float moment = 1.5F;  // seconds
  if (g.ActiveId == 0) return false;
  return g.ActiveId != g.InputTextState.ID || g.InputTextState.CursorAnim < moment;
}

}  // namespace

float place_tip(TipBeside beside, const std::function<ImVec2(float width)>& size_of_text) {
  const ImGuiContext& g = *GImGui;
  const float unit = ImGui::GetFontSize(), gap = tip_gap * unit;
  const ImVec2 padding = g.Style.WindowPadding, screen = g.IO.DisplaySize;
  const ImRect rows = beside == TipBeside::menu ? menus_of(*g.CurrentWindow) : rows_of(*g.CurrentWindow);
  float wrap = widest_tip * unit;
  const auto size = [&] {
    const ImVec2 words = size_of_text(wrap);
    return ImVec2(words.x + 2 * padding.x, words.y + 2 * padding.y);
  };
  const auto stand = [&](float x) {
    const float y = std::clamp(std::min(ImGui::GetItemRectMin().y, g.IO.MousePos.y), 0.0F,
                               std::max(0.0F, screen.y - size().y));
    ImGui::SetNextWindowPos({x, y});
  };
  const float left = rows.Min.x - gap, right = screen.x - rows.Max.x - gap;
  if (left >= size().x) {
    stand(left - size().x);
  } else if (right >= size().x) {
    stand(rows.Max.x + gap);
  } else if (const float room = std::max(left, right); room >= narrowest_tip * unit) {
    wrap = room - 2 * padding.x;
    stand(left > right ? left - size().x : rows.Max.x + gap);
  } else {
    // The rows fill the window: the tip lies over those above, which have been read.
    const float y = ImGui::GetItemRectMin().y - gap - size().y;
    if (y >= 0) ImGui::SetNextWindowPos({std::min(g.IO.MousePos.x, screen.x - size().x), y});
  }
  return wrap;
}

void show_tip(const char* text) {
  if (!*text || hands_are_busy()) return;
  std::string lines;
  place_tip(TipBeside::panel, [&](float width) {
    lines = in_lines(text, width);
    return ImGui::CalcTextSize(lines.c_str());
  });
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(lines.c_str());
  ImGui::EndTooltip();
}

void show_tip(const std::string& text) {
  show_tip(text.c_str());
}

void pointer_tip(const std::string& text) {
  ImGui::SetTooltip("%s", text.c_str());
}

}  // namespace hariko

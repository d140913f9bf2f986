#include "ui/widgets/tips.hpp"

#include <imgui_internal.h>

#include <algorithm>

namespace hariko {

namespace {

// In heights of the font.
constexpr float widest_panel = 44, widest_tip = 24, tip_gap = 0.4F;

/// The window whose rows a tip must not cover, with the lists that are open over it.
ImRect rows_of(const ImGuiWindow& window) {
  ImRect rows = window.RootWindow->Rect();
  for (const ImGuiWindow* at = window.RootWindow; (at->Flags & ImGuiWindowFlags_Popup) && at->ParentWindow;) {
    at = at->ParentWindow->RootWindow;
    rows.Add(at->Rect());
  }
  return rows;
}

}  // namespace

void show_tip(const char* text) {
  const ImGuiContext& g = *GImGui;
  if (!*text || g.ActiveId != 0) return;
  const float unit = ImGui::GetFontSize();
  const float wrap = widest_tip * unit;
  const ImVec2 padding = g.Style.WindowPadding;
  const ImVec2 words = ImGui::CalcTextSize(text, nullptr, false, wrap);
  const ImVec2 size(words.x + 2 * padding.x, words.y + 2 * padding.y);
  const ImRect rows = rows_of(*g.CurrentWindow);
  const ImVec2 screen = g.IO.DisplaySize;
  if (rows.GetWidth() <= widest_panel * unit) {
    const float y = std::clamp(std::min(ImGui::GetItemRectMin().y, g.IO.MousePos.y), 0.0F,
                               std::max(0.0F, screen.y - size.y));
    if (rows.Min.x >= size.x + tip_gap * unit)
      ImGui::SetNextWindowPos({rows.Min.x - tip_gap * unit - size.x, y});
    else if (screen.x - rows.Max.x >= size.x + tip_gap * unit)
      ImGui::SetNextWindowPos({rows.Max.x + tip_gap * unit, y});
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(wrap);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void show_tip(const std::string& text) {
  show_tip(text.c_str());
}

}  // namespace hariko

#include "ui/widgets/tips.hpp"

#include <imgui_internal.h>

#include <algorithm>

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

}  // namespace

void show_tip(const char* text) {
  const ImGuiContext& g = *GImGui;
  if (!*text || g.ActiveId != 0) return;
  const float unit = ImGui::GetFontSize(), gap = tip_gap * unit;
  const ImVec2 padding = g.Style.WindowPadding, screen = g.IO.DisplaySize;
  const ImRect rows = rows_of(*g.CurrentWindow);
  float wrap = widest_tip * unit;
  const auto size = [&] {
    const ImVec2 words = ImGui::CalcTextSize(text, nullptr, false, wrap);
    return ImVec2(words.x + 2 * padding.x, words.y + 2 * padding.y);
  };
  const auto beside = [&](float x) {
    const float y = std::clamp(std::min(ImGui::GetItemRectMin().y, g.IO.MousePos.y), 0.0F,
                               std::max(0.0F, screen.y - size().y));
    ImGui::SetNextWindowPos({x, y});
  };
  const float left = rows.Min.x - gap, right = screen.x - rows.Max.x - gap;
  if (left >= size().x) {
    beside(left - size().x);
  } else if (right >= size().x) {
    beside(rows.Max.x + gap);
  } else if (const float room = std::max(left, right); room >= narrowest_tip * unit) {
    wrap = room - 2 * padding.x;
    beside(left > right ? left - size().x : rows.Max.x + gap);
  } else {
    // The rows fill the window: the tip lies over those above, which have been read.
    const float y = ImGui::GetItemRectMin().y - gap - size().y;
    if (y >= 0) ImGui::SetNextWindowPos({std::min(g.IO.MousePos.x, screen.x - size().x), y});
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

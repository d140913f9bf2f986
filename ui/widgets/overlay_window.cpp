#include "ui/widgets/overlay_window.hpp"

#include "ui/base/language.hpp"

namespace hariko {

bool begin_overlay(const char* id, bool& open, const PanelRect& rect, const Metrics& metrics) {
  const bool shown = ImGui::IsPopupOpen(id);
  if (!open && !shown) return false;
  if (!shown) ImGui::OpenPopup(id);
  ImGui::SetNextWindowPos(rect.min);
  ImGui::SetNextWindowSize({rect.width(), rect.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, metrics.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, metrics.px(1));
  const bool drawn = ImGui::BeginPopupModal(id, nullptr,
                                            ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                                ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings |
                                                ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar(2);
  if (!drawn) return false;
  const bool outside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsMouseHoveringRect(rect.min, rect.max, false);
  if (outside && !ImGui::IsWindowAppearing()) open = false;
  if (open) return true;
  ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return false;
}

void end_overlay() {
  ImGui::EndPopup();
}

namespace {

template <class Take>
void each_chord(std::string_view keys, Take take) {
  while (!keys.empty()) {
    const std::size_t end = keys.find(" / ");
    take(std::string(keys.substr(0, end)));
    keys = end == std::string_view::npos ? std::string_view() : keys.substr(end + 3);
  }
}

}  // namespace

float keys_width(const Metrics& m, std::string_view keys) {
  float width = 0;
  each_chord(keys, [&](const std::string& chord) {
    width += (width > 0 ? m.px(4) : 0) + ImGui::CalcTextSize(chord.c_str()).x + m.px(12);
  });
  return width;
}

float draw_keys(ImDrawList& list, const Metrics& m, float right, float y, std::string_view keys) {
  float x = right - keys_width(m, keys);
  const float left = x;
  each_chord(keys, [&](const std::string& chord) {
    const ImVec2 size = ImGui::CalcTextSize(chord.c_str());
    const ImVec2 end(x + size.x + m.px(12), y + size.y + m.px(2));
    list.AddRectFilled({x, y - m.px(2)}, end, palette().field, m.px(4));
    list.AddRect({x, y - m.px(2)}, end, palette().separator, m.px(4));
    list.AddText({x + m.px(6), y}, palette().dim_text, chord.c_str());
    x = end.x + m.px(4);
  });
  return left;
}

std::string elided(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string cut = text;
  while (!cut.empty() && ImGui::CalcTextSize((cut + "\u2026").c_str()).x > width) {
    // Whole characters: bytes that continue one go with it.
    while (cut.size() > 1 && (static_cast<unsigned char>(cut.back()) & 0xc0U) == 0x80U) cut.pop_back();
    cut.pop_back();
  }
  return cut + "\u2026";
}

}  // namespace hariko

#include "ui/widgets/inputs.hpp"

#include <imgui_stdlib.h>

namespace hariko {

namespace {

int take_arrow_key(ImGuiInputTextCallbackData* data) {
  const auto& arrows = *static_cast<const ArrowKeys*>(data->UserData);
  const auto text = arrows({data->Buf, static_cast<std::size_t>(data->BufTextLen)},
                           data->EventKey == ImGuiKey_UpArrow ? 1 : -1);
  if (!text) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, text->c_str());
  data->SelectAll();
  return 0;
}

}  // namespace

bool text_field(Marks& marks, const std::string& mark, std::string& text, float width, const char* hint,
                ImGuiInputTextFlags flags, ArrowKeys arrows) {
  ImGui::SetNextItemWidth(width);
  if (arrows) flags |= ImGuiInputTextFlags_CallbackHistory;
  const bool changed = ImGui::InputTextWithHint(("##" + mark).c_str(), hint, &text, flags,
                                                arrows ? &take_arrow_key : nullptr, &arrows);
  marks.item(mark);
  return changed;
}

bool colour_field(Marks& marks, const std::string& mark, std::array<float, 3>& colour) {
  ImGui::SetNextItemWidth(-1);
  const bool changed =
      ImGui::ColorEdit3(("##" + mark).c_str(), colour.data(), ImGuiColorEditFlags_DisplayHex);
  marks.item(mark);
  return changed;
}

int arrow_step() {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) -
         ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow));
}

}  // namespace hariko

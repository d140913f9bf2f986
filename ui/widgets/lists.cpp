#include "ui/widgets/lists.hpp"

namespace hariko {

OpenScope list_scope(Marks& marks, const std::string& mark, const std::string& now, float width,
                     ImGuiComboFlags flags) {
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo(("##" + mark).c_str(), now.c_str(), flags);
  marks.item(mark);
  return {open, &ImGui::EndCombo};
}

OpenScope menu_scope(Marks& marks, const std::string& mark, const std::string& label) {
  const bool open = ImGui::BeginMenu(label.c_str());
  marks.item(mark);
  return {open, &ImGui::EndMenu};
}

OpenScope popup_scope(const std::string& id, ImGuiWindowFlags flags) {
  return {ImGui::BeginPopup(id.c_str(), flags), &ImGui::EndPopup};
}

OpenScope item_menu_scope(const char* id) {
  return {ImGui::BeginPopupContextItem(id), &ImGui::EndPopup};
}

OpenScope dialog_scope(const std::string& title, ImGuiWindowFlags flags) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
  return {ImGui::BeginPopupModal(title.c_str(), nullptr, flags), &ImGui::EndPopup};
}

OpenScope table_scope(const char* id, int columns) {
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoPadOuterX;
  return {ImGui::BeginTable(id, columns, flags), &ImGui::EndTable};
}

void next_cell() {
  ImGui::TableNextColumn();
}

bool selectable_row(Marks& marks, const std::string& mark, const std::string& text, bool chosen, ImVec2 size,
                    ImGuiSelectableFlags flags) {
  const bool pressed = ImGui::Selectable((text + "###" + mark).c_str(), chosen, flags, size);
  marks.item(mark);
  return pressed;
}

bool menu_row(Marks& marks, const std::string& mark, const std::string& text, bool checked, bool enabled) {
  const bool pressed = ImGui::MenuItem((text + "###" + mark).c_str(), nullptr, checked, enabled);
  marks.item(mark);
  return pressed;
}

}  // namespace hariko

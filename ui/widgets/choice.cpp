#include "ui/widgets/choice.hpp"

#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

std::optional<int> choose(PanelContext& context, const char* id, const char* label, const char* help,
                          std::span<const Choice> choices, int current) {
  const Language& tr = context.tr;
  row_label(context, tr(label), tr(help));
  std::optional<int> chosen;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushID(id);
  const bool open = ImGui::BeginCombo(
      "##combo", current < 0 ? tr("mixed") : tr(choices[static_cast<std::size_t>(current)].label),
      ImGuiComboFlags_HeightLarge);  // a dozen without scrolling
  context.marks.item(std::string("combo.") + id);
  point_out(context, id);
  if (open) {
    for (int i = 0; i < static_cast<int>(choices.size()); ++i) {
      const Choice& choice = choices[static_cast<std::size_t>(i)];
      if (ImGui::Selectable(tr(choice.label), i == current)) chosen = i;
      if (i == current) ImGui::SetItemDefaultFocus();
      context.marks.item("choice." + std::string(id) + "." + std::to_string(i));
      if (*choice.help && ImGui::IsItemHovered()) show_tip(tr(choice.help));
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  return chosen;
}

}  // namespace hariko

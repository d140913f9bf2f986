#include "ui/widgets/choice.hpp"

#include "ui/widgets/lists.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

std::optional<int> choose(PanelContext& context, const char* id, const char* label, const char* help,
                          std::span<const Choice> choices, int current) {
  const Language& tr = context.tr;
  row_label(context, tr(label), tr(help));
  std::optional<int> chosen;
  const OpenScope list =
      list_scope(context.marks, std::string("combo.") + id,
                 current < 0 ? tr("mixed") : tr(choices[static_cast<std::size_t>(current)].label), -1,
                 ImGuiComboFlags_HeightLarge);  // a dozen without scrolling
  point_out(context, id);
  for (int i = 0; list && i < static_cast<int>(choices.size()); ++i) {
    const Choice& choice = choices[static_cast<std::size_t>(i)];
    if (selectable_row(context.marks, "choice." + std::string(id) + "." + std::to_string(i), tr(choice.label),
                       i == current))
      chosen = i;
    if (i == current) ImGui::SetItemDefaultFocus();
    if (*choice.help && ImGui::IsItemHovered()) show_tip(tr(choice.help));
  }
  return chosen;
}

std::optional<int> choice_menu(PanelContext& context, const std::string& mark,
                               std::span<const Choice> choices, int current) {
  std::optional<int> chosen;
  const auto label = [&](int i) { return context.tr(choices[static_cast<std::size_t>(i)].label); };
  if (ImGui::SmallButton((std::string(label(current)) + "###" + mark).c_str()))
    ImGui::OpenPopup(mark.c_str());
  context.marks.item(mark);
  const OpenScope menu = popup_scope(mark);
  for (int i = 0; menu && i < static_cast<int>(choices.size()); ++i)
    if (menu_row(context.marks, mark + "." + std::to_string(i), label(i), i == current)) chosen = i;
  return chosen;
}

}  // namespace hariko

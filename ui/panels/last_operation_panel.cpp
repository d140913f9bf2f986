// The section of the properties that adjusts the step just made.

#include "ui/panels/panels.hpp"
#include "ui/panels/value_fields.hpp"

namespace hariko {

void draw_last_operation(PanelContext& context) {
  Editor& editor = context.editor;
  LastOperation& last = editor.last_operation;
  if (!last.can_adjust(editor) || last.numbers().empty()) return;
  heading(context, context.tr.phrase(last.label()).c_str());
  const std::string unit(to_string(editor.document().unit));
  // Adjusting replaces the list: what is drawn is this frame's.
  const std::vector<OperationNumber> numbers = last.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const OperationNumber& number = numbers[i];
    row_label(context, context.tr(number.label), "");
    ImGui::PushID(number.id);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (number.whole) {
      int shown = static_cast<int>(number.value);
      if (ImGui::InputInt("##number", &shown, 1, 10, ImGuiInputTextFlags_AutoSelectAll))
        context.state.typed = shown;
    } else {
      double shown = number.value;
      if (ImGui::InputDouble("##number", &shown, 0, 0, ("%.6g " + unit).c_str(),
                             ImGuiInputTextFlags_AutoSelectAll))
        context.state.typed = shown;
    }
    const bool entered = ImGui::IsItemDeactivatedAfterEdit();
    context.marks.item(std::string("last.") + number.id);
    ImGui::PopID();
    if (entered) {
      last.adjust(editor, i, context.state.typed);
      break;
    }
  }
}

}  // namespace hariko

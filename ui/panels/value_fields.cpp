#include "ui/panels/value_fields.hpp"

#include <cmath>

namespace hariko {

namespace {

constexpr float label_width = 84, field_width = 74;

/// Carries a gesture of the last item to its end.
void end_gesture(Editor& editor, const std::string& step) {
  if (ImGui::IsItemDeactivatedAfterEdit())
    editor.commit_preview(step);
  else if (ImGui::IsItemDeactivated())
    editor.cancel_preview();
}

}  // namespace

void row_label(const PanelContext& context, const char* label, const char* help) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  if (*help && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::SameLine(context.metrics.px(label_width + 12));
}

void value_slider(PanelContext& context, const SliderSpec& spec, std::optional<double> value,
                  const EditValue& edit) {
  Editor& editor = context.editor;
  row_label(context, spec.label, spec.help);
  ImGui::PushID(spec.id);
  const float field = context.metrics.px(field_width);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - field - ImGui::GetStyle().ItemSpacing.x);
  double shown = value.value_or(spec.low);
  ImGuiSliderFlags flags = ImGuiSliderFlags_NoInput | ImGuiSliderFlags_NoRoundToFormat;
  if (spec.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
  const bool moved = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &shown, &spec.low, &spec.high,
                                         value ? "" : "mixed", flags);
  if (moved) {
    // Four digits are enough for a hand on a slider and read better than sixteen.
    const double digits = std::pow(10, 3 - std::floor(std::log10(std::max(std::abs(shown), 1e-9))));
    editor.preview(
        edit(editor.history.current(), spec.whole ? std::round(shown) : std::round(shown * digits) / digits));
  }
  if (*spec.help && ImGui::IsItemHovered() && !ImGui::IsItemActive()) ImGui::SetTooltip("%s", spec.help);
  end_gesture(editor, spec.step);
  context.marks.item(std::string("slider.") + spec.id);
  ImGui::SameLine();
  number_field(context, spec.id, value, spec.whole ? "%.0f" : "%.4g", field, spec.step, edit);
  ImGui::PopID();
}

void number_field(PanelContext& context, const char* id, std::optional<double> value, const char* format,
                  float width, const std::string& step, const EditValue& edit) {
  ImGui::PushID(id);
  ImGui::SetNextItemWidth(width);
  double shown = value.value_or(0);
  if (ImGui::InputDouble("##number", &shown, 0, 0, value ? format : "", ImGuiInputTextFlags_AutoSelectAll))
    context.state.typed = shown;
  if (ImGui::IsItemDeactivatedAfterEdit())
    context.editor.commit(edit(context.editor.history.current(), context.state.typed), step);
  context.marks.item(std::string("field.") + id);
  ImGui::PopID();
}

}  // namespace hariko

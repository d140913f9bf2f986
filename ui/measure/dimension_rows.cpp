#include "ui/measure/dimension_rows.hpp"

#include <imgui.h>

#include <array>
#include <string>

#include "core/document/edits/edit_dimensions.hpp"
#include "ui/base/icons.hpp"
#include "ui/measure/dimension_text.hpp"
#include "ui/widgets/overlay_window.hpp"
#include "ui/widgets/tips.hpp"
#include "ui/widgets/value_fields.hpp"

namespace hariko {

namespace {

constexpr std::size_t most_rows_at_once = 10;
constexpr float button_size = 22;  // design pixels

void dimension_row(PanelContext& context, const ShownDimension& shown) {
  Editor& editor = context.editor;
  const Dimension& dimension = shown.dimension;
  const std::string number = std::to_string(dimension.id.value), mark = "dimension_row." + number;
  const bool chosen = editor.dimensions.chosen(editor) == dimension.id;
  ImGui::PushID(static_cast<int>(dimension.id.value));
  row_label(context, dimension_name(dimension.kind), "");
  const float buttons = 2 * context.metrics.px(button_size + 4);
  const std::string text =
      shown.measured ? dimension_text(dimension.kind, *shown.measured, editor.document().unit, context.tr)
                     : std::string(context.tr("no value"));
  const float start = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const std::string fitting = elided(text, room - buttons - context.metrics.px(4));
  if (ImGui::Selectable((fitting + "##value").c_str(), chosen, 0,
                        {room - buttons, context.metrics.px(button_size)}))
    editor.dimensions.choose(editor, dimension.id);
  context.marks.item(mark);
  if (!shown.measured && ImGui::IsItemHovered())
    show_tip(context.tr("The surface that it measures is not there, or has no such point any more."));
  else if (fitting != text && ImGui::IsItemHovered())
    show_tip(text);
  ImGui::SameLine(start + room - buttons);
  {
    const Disabled disabled(!shown.measured);
    if (icon_button(context, icon::copy, "copy", "Copy the value", false, button_size) && shown.measured)
      ImGui::SetClipboardText(
          exact_dimension_text(dimension.kind, *shown.measured, editor.document().unit).c_str());
    context.marks.item(mark + ".copy");
  }
  ImGui::SameLine(0, context.metrics.px(4));
  if (icon_button(context, icon::trash, "delete", "Delete the dimension", false, button_size))
    later(context, remove_dimensions(editor.history.current(), std::array{dimension.id}),
          translatable("Delete dimension"));
  context.marks.item(mark + ".delete");
  ImGui::PopID();
}

}  // namespace

void dimension_section(PanelContext& context) {
  Editor& editor = context.editor;
  const std::vector<ShownDimension>& all = editor.dimensions.all();
  if (all.empty()) return;
  heading(context, "Dimensions");
  const bool many = all.size() > most_rows_at_once;
  if (many)
    ImGui::BeginChild("dimensions",
                      {0, (float(most_rows_at_once) + 0.5F) * ImGui::GetFrameHeightWithSpacing()}, false,
                      ImGuiWindowFlags_NavFlattened);
  for (const ShownDimension& shown : all) dimension_row(context, shown);
  if (many) ImGui::EndChild();
  if (!editor.view.dimensions)
    hint_text(context, "Hidden in the views: Analyse > Measure > Show dimensions.");
}

}  // namespace hariko

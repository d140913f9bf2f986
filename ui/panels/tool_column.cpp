// The column of buttons on the left: commands that are used all the time.

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/panels/command_menu.hpp"

namespace hariko {

namespace {

void command_button(PanelContext& context, const char* id) {
  const Command& command = *context.commands.find(id);
  const auto reason = command.why_not ? command.why_not() : std::nullopt;
  if (reason) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4F);
  if (icon_button(context, command.icon, id, "", command.checked && command.checked(), 36)) context.run(id);
  if (reason) ImGui::PopStyleVar();
  if (ImGui::IsItemHovered()) command_tooltip(context, command, reason, true);
  context.marks.item(std::string("button.") + id);
}

void gap(PanelContext& context) {
  ImGui::Dummy({1, context.metrics.px(8)});
}

}  // namespace

void draw_tool_column(PanelContext& context, const PanelRect& rect) {
  const float pad = context.metrics.px(4);
  if (begin_panel("Tools", rect, palette().window, {pad, context.metrics.px(8)},
                  ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, context.metrics.px(2)));
    for (const char* id : {"select.vertices", "select.edges", "select.faces"}) command_button(context, id);
    gap(context);
    for (const char* id : {"edit.undo", "edit.redo"}) command_button(context, id);
    gap(context);
    for (const char* id : {"view.frame_all", "view.x_ray"}) command_button(context, id);
    ImGui::PopStyleVar();
  }
  ImGui::End();
}

}  // namespace hariko

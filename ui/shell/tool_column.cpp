// The column of buttons on the left: commands that are used all the time. Where the window is low it has two
// rows of them side by side, so that it never scrolls.

#include "ui/base/icons.hpp"
#include "ui/widgets/command_menu.hpp"

namespace hariko {

namespace {

void command_button(PanelContext& context, const char* id) {
  const Command& command = *context.commands.find(id);
  const auto reason = command.why_not ? command.why_not() : std::nullopt;
  if (reason) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4F);
  if (icon_button(context, command.icon, std::string("button.") + id, "",
                  command.checked && command.checked(), 36))
    context.run(id);
  if (reason) ImGui::PopStyleVar();
  if (ImGui::IsItemHovered()) command_tooltip(context, command, reason, true);
}

/// Groups from top to bottom. The bevel is that of what clicks select.
std::vector<std::vector<const char*>> tool_groups(ElementMode mode) {
  const char* bevel = mode == ElementMode::vertex ? "mesh.bevel_vertices" : "mesh.bevel_edges";
  return {
      {"select.vertices", "select.edges", "select.faces", "select.objects"},
      {"select.lasso"},
      {"transform.move", "transform.rotate", "transform.scale"},
      {"mesh.extrude", "mesh.inset", bevel, "mesh.loop_cut", "mesh.knife"},
      {"edit.undo", "edit.redo"},
      {"view.frame_all", "view.x_ray"},
  };
}
constexpr float button_side = 36, spacing = 2, gap = 8;

}  // namespace

float tool_column_width(const Metrics& m, float height) {
  float needed = m.px(2 * gap);
  for (const auto& group : tool_groups(ElementMode::vertex))
    needed += m.px(button_side + spacing) * static_cast<float>(group.size()) + m.px(gap);
  return needed <= height ? m.px(button_side + 8) : m.px(2 * button_side + spacing + 8);
}

void draw_tool_column(PanelContext& context, const PanelRect& rect) {
  const Metrics& m = context.metrics;
  if (begin_panel("Tools", rect, palette().window, {m.px(4), m.px(gap)}, ImGuiWindowFlags_NoScrollbar)) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(m.px(spacing), m.px(spacing)));
    const bool pairs = rect.width() > m.px(2 * button_side);
    for (const auto& group : tool_groups(context.editor.mode)) {
      for (std::size_t i = 0; i < group.size(); ++i) {
        if (pairs && i % 2 == 1) ImGui::SameLine();
        command_button(context, group[i]);
      }
      ImGui::Dummy({1, m.px(gap) - m.px(spacing)});
    }
    ImGui::PopStyleVar();
  }
  ImGui::End();
}

}  // namespace hariko

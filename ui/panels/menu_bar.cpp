// The menu bar: the command table by menus, and the name of the document.

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/panels/command_menu.hpp"

namespace hariko {

float draw_menu_bar(PanelContext& context) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(context.metrics.px(10), context.metrics.px(6)));
  const bool open = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!open) return 0;
  for (const std::string& menu : context.commands.menus()) {
    const bool shown = ImGui::BeginMenu((context.tr(menu) + "###" + menu).c_str());
    context.marks.item("menu." + menu);
    if (!shown) continue;
    draw_menu_nodes(context, menu_tree(context.commands, menu), "command.");
    ImGui::EndMenu();
  }
  const Editor& editor = context.editor;
  if (editor.has_document) {
    std::string title = context.tr(editor.title());
    if (editor.history.dirty()) title += std::string("  \u2022  ") + context.tr("edited");
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SameLine(ImGui::GetWindowWidth() - width - context.metrics.px(28));
    const TextColour colour(palette().dim_text);
    ImGui::TextUnformatted(title.c_str());
  }
  const float height = ImGui::GetWindowHeight();
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace hariko

// The menu bar: the command table by menus, and the name of the document.

#include <algorithm>

#include "ui/icons.hpp"
#include "ui/panels/command_menu.hpp"

namespace hariko {

namespace {

/// The way to the palette for those who do not know its key; looks like a field. Gives its left end.
float search_field(PanelContext& context) {
  const Metrics& m = context.metrics;
  const Command& search = *context.commands.find("help.palette");
  const std::string text = std::string(icon::search) + "  " + context.tr("Search");
  const std::string key = first_key(search);
  const ImVec2 size(m.px(170), ImGui::GetTextLineHeight() + m.px(6));
  const float left = ImGui::GetWindowWidth() - size.x - m.px(10);
  ImGui::SetCursorPosX(left);
  const ImVec2 at(ImGui::GetCursorScreenPos().x, (ImGui::GetWindowHeight() - size.y) / 2);
  ImGui::SetCursorScreenPos(at);
  const bool pressed = ImGui::InvisibleButton("search", size);
  context.marks.item("menu.search");
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) command_tooltip(context, search, {}, true);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, hovered ? palette().field_hover : palette().field,
                     m.px(4));
  draw.AddText({at.x + m.px(8), at.y + m.px(3)}, palette().dim_text, text.c_str());
  draw.AddText({at.x + size.x - ImGui::CalcTextSize(key.c_str()).x - m.px(8), at.y + m.px(3)},
               palette().dim_text, key.c_str());
  if (pressed) context.run(search.id);
  return left;
}

}  // namespace

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
  const float used = ImGui::GetCursorPosX();
  const float field = search_field(context);
  const Editor& editor = context.editor;
  if (editor.has_document) {
    std::string title = context.tr(editor.title());
    if (editor.read_only) title += std::string("  \u2022  ") + context.tr("read-only");
    if (editor.history.dirty()) title += std::string("  \u2022  ") + context.tr("edited");
    // The window's own title has it too: here it goes where there is room.
    const float left = field - ImGui::CalcTextSize(title.c_str()).x - context.metrics.px(16);
    if (left > used + context.metrics.px(8)) {
      const float y = ImGui::GetWindowPos().y + (ImGui::GetWindowHeight() - ImGui::GetTextLineHeight()) / 2;
      ImGui::GetWindowDrawList()->AddText({left, y}, palette().dim_text, title.c_str());
    }
  }
  const float height = ImGui::GetWindowHeight();
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace hariko

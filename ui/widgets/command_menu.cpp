#include "ui/widgets/command_menu.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"
#include "ui/widgets/items.hpp"
#include "ui/widgets/lists.hpp"
#include "ui/widgets/tips.hpp"

namespace hariko {

namespace {

/// Sentence of a tip; its keys stand behind it.
struct TipPart {
  std::string text, keys;
  ImU32 colour;
};

}  // namespace

void draw_menu_nodes(PanelContext& context, const std::vector<MenuNode>& nodes, const char* prefix) {
  const Language& tr = context.tr;
  for (const MenuNode& node : nodes) {
    if (node.separator_before) ImGui::Separator();
    if (!node.command) {
      const OpenScope menu =
          menu_scope(context.marks, "menu." + node.submenu, tr(node.submenu) + "###" + node.submenu);
      if (menu) draw_menu_nodes(context, node.children, prefix);
      continue;
    }
    draw_menu_item(context, *node.command, prefix);
  }
}

void draw_menu_items(PanelContext& context, std::initializer_list<const char*> ids, const char* prefix) {
  for (const char* id : ids) {
    if (!*id) ImGui::Separator();
    if (const Command* command = context.commands.find(id)) draw_menu_item(context, *command, prefix);
  }
}

void draw_menu_item(PanelContext& context, const Command& command, const char* prefix) {
  const auto reason = command.why_not ? command.why_not() : std::nullopt;
  const std::string label = context.tr(command.label) + "###" + command.id;
  const bool chosen = ImGui::MenuItem(label.c_str(), first_key(command).c_str(),
                                      command.checked && command.checked(), !reason);
  context.marks.item(prefix + command.id);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    command_tooltip(context, command, reason, false);
  if (chosen) context.run(command.id);
}

void command_tooltip(const PanelContext& context, const Command& command,
                     const std::optional<std::string>& reason, bool with_label) {
  const Language& tr = context.tr;
  std::vector<TipPart> parts;
  if (with_label) parts.push_back({tr(command.label), command.keys, palette().text});
  if (!command.help.empty())
    parts.push_back({tr(command.help), {}, with_label ? palette().dim_text : palette().text});
  if (reason) parts.push_back({tr.phrase(*reason), {}, palette().warning});
  if (parts.empty()) return;
  const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
  const float keys_at = context.metrics.px(16);
  const float width = place_tip(with_label ? TipBeside::panel : TipBeside::menu, [&](float most) {
    ImVec2 size(0, -spacing.y);
    for (const TipPart& part : parts) {
      const ImVec2 words = ImGui::CalcTextSize(in_lines(part.text, most).c_str());
      const float keys = part.keys.empty() ? 0 : keys_at + ImGui::CalcTextSize(part.keys.c_str()).x;
      size = {std::max(size.x, words.x + keys), size.y + words.y + spacing.y};
    }
    return size;
  });
  ImGui::BeginTooltip();
  for (const TipPart& part : parts) {
    coloured_text(part.colour, in_lines(part.text, width).c_str());
    if (part.keys.empty()) continue;
    ImGui::SameLine(0, keys_at);
    ImGui::TextDisabled("%s", part.keys.c_str());
  }
  ImGui::EndTooltip();
}

std::string first_key(const Command& command) {
  return command.keys.substr(0, command.keys.find(" / "));
}

std::string menu_path(const Language& tr, const Command& command) {
  std::string path;
  for (const std::string& folder : menu_folders(command.menu)) {
    if (!path.empty()) path += " \u203a ";
    path += tr(folder);
  }
  return path;
}

}  // namespace hariko

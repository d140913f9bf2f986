#include "ui/widgets/command_menu.hpp"

#include "ui/base/icons.hpp"
#include "ui/base/text_lines.hpp"

namespace hariko {

void draw_menu_nodes(PanelContext& context, const std::vector<MenuNode>& nodes, const char* prefix) {
  const Language& tr = context.tr;
  for (const MenuNode& node : nodes) {
    if (node.separator_before) ImGui::Separator();
    if (!node.command) {
      const bool shown = ImGui::BeginMenu((std::string(tr(node.submenu)) + "###" + node.submenu).c_str());
      context.marks.item("menu." + node.submenu);
      if (!shown) continue;
      draw_menu_nodes(context, node.children, prefix);
      ImGui::EndMenu();
      continue;
    }
    const Command& command = *node.command;
    const auto reason = command.why_not ? command.why_not() : std::nullopt;
    const std::string label = tr(command.label) + "###" + command.id;
    const bool chosen = ImGui::MenuItem(label.c_str(), first_key(command).c_str(),
                                        command.checked && command.checked(), !reason);
    context.marks.item(prefix + command.id);
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
      command_tooltip(context, command, reason, false);
    if (chosen) context.run(command.id);
  }
}

void command_tooltip(const PanelContext& context, const Command& command,
                     const std::optional<std::string>& reason, bool with_label) {
  const Language& tr = context.tr;
  ImGui::BeginTooltip();
  const float right = context.metrics.px(320);
  if (with_label) {
    ImGui::TextUnformatted(tr(command.label.c_str()));
    if (!command.keys.empty()) {
      ImGui::SameLine(0, context.metrics.px(16));
      ImGui::TextDisabled("%s", command.keys.c_str());
    }
  }
  if (!command.help.empty()) {
    const TextColour colour(with_label ? palette().dim_text : palette().text);
    text_in_lines(tr(command.help.c_str()), right);
  }
  if (reason) {
    const TextColour colour(palette().warning);
    text_in_lines(tr.phrase(*reason), right);
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

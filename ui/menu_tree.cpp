#include "ui/menu_tree.hpp"

#include <algorithm>

namespace hariko {

namespace {

/// Puts a command below the folders, which are made where they do not exist yet.
void place(std::vector<MenuNode>& nodes, std::span<const std::string> folders, const Command& command,
           bool separator) {
  if (folders.empty()) {
    nodes.push_back({&command, {}, separator, {}});
    return;
  }
  auto it = std::find_if(nodes.begin(), nodes.end(),
                         [&](const MenuNode& n) { return !n.command && n.submenu == folders[0]; });
  if (it == nodes.end()) {
    nodes.push_back({nullptr, folders[0], separator, {}});
    it = nodes.end() - 1;
    separator = false;  // it stands before the submenu
  }
  place(it->children, folders.subspan(1), command, separator);
}

}  // namespace

std::vector<std::string> menu_folders(std::string_view menu) {
  std::vector<std::string> folders;
  while (!menu.empty()) {
    const std::size_t end = menu.find('/');
    folders.emplace_back(menu.substr(0, end));
    menu = end == std::string_view::npos ? std::string_view() : menu.substr(end + 1);
  }
  return folders;
}

std::vector<MenuNode> menu_tree(const CommandTable& table, std::string_view menu) {
  std::vector<MenuNode> nodes;
  for (const Command& command : table.all()) {
    const auto folders = menu_folders(command.menu);
    if (folders.empty() || folders[0] != menu) continue;
    place(nodes, std::span(folders).subspan(1), command, command.separator_before && !nodes.empty());
  }
  return nodes;
}

std::vector<MenuNode> context_menu_tree(const CommandTable& table, Context context) {
  std::vector<MenuNode> nodes;
  for (const std::string& menu : table.menus()) {
    bool first = !nodes.empty();
    for (const Command& command : table.all()) {
      const auto folders = menu_folders(command.menu);
      if (folders.empty() || folders[0] != menu || !overlap(command.contexts, context)) continue;
      place(nodes, std::span(folders).subspan(1), command, first);
      first = false;
    }
  }
  return nodes;
}

}  // namespace hariko

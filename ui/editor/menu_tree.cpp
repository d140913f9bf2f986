#include "ui/editor/menu_tree.hpp"

#include <algorithm>
#include <array>

namespace hariko {

namespace {

/// What is done to a thing stands before what is done with it; other menus come last, in the order of the
/// bar.
constexpr std::array<std::string_view, 8> context_order{"Add",  "Mesh", "Shape",  "Transform",
                                                        "Edit", "File", "Select", "View"};
std::ptrdiff_t place_in_context(std::string_view menu) {
  return std::find(context_order.begin(), context_order.end(), menu) - context_order.begin();
}

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

/// A line round each single entry is no grouping: it goes with the group before.
void join_single_nodes(std::span<MenuNode> nodes) {
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (i + 1 == nodes.size() || nodes[i + 1].separator_before) nodes[i].separator_before = false;
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
  std::vector<std::string> menus = table.menus();
  std::stable_sort(menus.begin(), menus.end(), [](const std::string& a, const std::string& b) {
    return place_in_context(a) < place_in_context(b);
  });
  std::vector<MenuNode> nodes;
  for (const std::string& menu : menus) {
    const std::size_t begin = nodes.size();
    bool separator = !nodes.empty();
    for (const Command& command : table.all()) {
      const auto folders = menu_folders(command.menu);
      if (folders.empty() || folders[0] != menu) continue;
      // The groups of the menu are groups here, whichever of their commands are shown.
      separator = separator || (command.separator_before && !nodes.empty());
      if (!overlap(command.contexts, context)) continue;
      // What can be added is a list of its own, and goes with other things.
      place(nodes, std::span(folders).subspan(menu == "Add" ? 0 : 1), command, separator);
      separator = false;
    }
    join_single_nodes(std::span(nodes).subspan(begin));
  }
  return nodes;
}

}  // namespace hariko

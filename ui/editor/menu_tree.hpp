#pragma once

// Menus as trees, made from the command table.

#include <string>
#include <vector>

#include "ui/editor/command_table.hpp"

namespace hariko {

/// An entry of a menu: a command, or a submenu with entries of its own.
struct MenuNode {
  const Command* command = nullptr;
  std::string submenu;  ///< its name in English when there is no command
  bool separator_before = false;
  std::vector<MenuNode> children;
};

/// The entries of a top menu. A submenu stands where its first command does.
std::vector<MenuNode> menu_tree(const CommandTable& table, std::string_view menu);

/// The entries of the context menu of an element: commands by menus, separated; submenus stay.
std::vector<MenuNode> context_menu_tree(const CommandTable& table, Context context);

/// The folders of a menu path: "View/Standard views" gives two.
std::vector<std::string> menu_folders(std::string_view menu);

}  // namespace hariko

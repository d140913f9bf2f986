#pragma once

// Menus made from the command table, in the bar and under the pointer.

#include <initializer_list>

#include "ui/editor/command_table.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Draws entries into an open menu. Items are marked `prefix` + id ("command.file.open"), submenus
/// "menu.Name".
void draw_menu_nodes(PanelContext& context, const std::vector<MenuNode>& nodes, const char* prefix);

/// Draws one command into an open menu, likewise marked.
void draw_menu_item(PanelContext& context, const Command& command, const char* prefix);

/// Draws commands by their ids, likewise; an empty id is a line between them, and an unknown one is left out.
void draw_menu_items(PanelContext& context, std::initializer_list<const char*> ids, const char* prefix);

/// Help of a command, and why it cannot run, beside the panel or, without the label, beside the menus of the
/// last item. `reason` is already known there.
void command_tooltip(const PanelContext& context, const Command& command,
                     const std::optional<std::string>& reason, bool with_label);

/// The first of a command's keys; the others are for those who know them.
std::string first_key(const Command& command);

/// "View › Standard views" in the language of the interface.
std::string menu_path(const Language& tr, const Command& command);

}  // namespace hariko

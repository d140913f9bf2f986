#pragma once

// CommandHost: what commands act on, the reasons that many of them share, and the functions that fill the
// command table, one for each menu or theme.

#include <functional>
#include <string>

#include "ui/editor/command_table.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

class ApplicationServices;
class CommandServices;
class Viewport;

struct CommandHost {
  CommandTable& table;
  Editor& editor;
  Viewport& viewport;
  CommandServices& services;
  ApplicationServices& application;
};

/// A folder of a menu: submenu("Select", translatable("Convert")).
inline std::string submenu(const char* menu, const char* folder) {
  return std::string(menu) + "/" + folder;
}

using Reason = std::optional<std::string>;
using WhyNot = std::function<Reason()>;

/// Why a command that needs a document, an active object, or an active polyhedron cannot run. The editor must
/// outlive the function.
WhyNot needs_document(const Editor& editor);
WhyNot needs_object(const Editor& editor);
WhyNot needs_polyhedron(const Editor& editor);
/// An active object that is drawn as a surface, of whatever kind; with `curves`, one whose surface has curves
/// over edges.
WhyNot needs_shown_surface(const Editor& editor, bool curves = false);
/// The active polyhedron with something selected of the kinds asked for.
struct NeededElements {
  bool vertices = false, edges = false, faces = false;
};
WhyNot needs_elements(const Editor& editor, NeededElements kinds);
/// The reason of `first`, and else the sentence `otherwise`, unless `holds`.
WhyNot only_if(std::function<bool()> holds, const char* otherwise);
WhyNot only_if(WhyNot first, std::function<bool()> holds, const char* otherwise);

/// The row of a switch, which turns `on` round and is checked while it is on. `on` must outlive the table.
Command switching(Command row, bool& on);

// Each in a file of its own. The host must outlive the table.
/// Stand among those of files.
void add_picture_commands(CommandHost& host);
void add_edit_commands(CommandHost& host);
void add_object_commands(CommandHost& host);
void add_group_commands(CommandHost& host);
void add_arrange_commands(CommandHost& host);
void add_select_commands(CommandHost& host);
void add_add_commands(CommandHost& host);
void add_solid_commands(CommandHost& host);
void add_mesh_cleanup_commands(CommandHost& host);
void add_transform_commands(CommandHost& host);
void add_mesh_commands(CommandHost& host);
void add_reference_commands(CommandHost& host);
void add_shape_commands(CommandHost& host);
void add_attach_commands(CommandHost& host);
void add_outline_commands(CommandHost& host);
void add_recompute_commands(CommandHost& host);
void add_paper_commands(CommandHost& host);
void add_view_commands(CommandHost& host);
void add_saved_view_commands(CommandHost& host);
/// Adds the commands of snapping, and of the plane in which tools draw.
void add_snap_commands(CommandHost& host);
void add_plane_commands(CommandHost& host);
void add_analyse_commands(CommandHost& host);
/// Adds the commands of environments, which stand behind the materials.
void add_environment_commands(CommandHost& host);
/// Adds the commands of section curves, which stand among those that analyse.
void add_section_curve_commands(CommandHost& host);
void add_measure_commands(CommandHost& host);
/// After all commands are there.
void fill_context_menus(CommandTable& table);
void add_language_commands(CommandHost& host);
void add_start_commands(CommandHost& host);

}  // namespace hariko

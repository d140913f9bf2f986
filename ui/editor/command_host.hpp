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

/// Reasons why a command that needs a document, an active object, or an active polyhedron cannot run. The
/// editor must outlive the function.
WhyNot needs_document(const Editor& editor);
WhyNot needs_object(const Editor& editor);
WhyNot needs_polyhedron(const Editor& editor);
/// An active object that is drawn as a surface, of whatever kind; with `curves`, one whose surface has curves
/// over edges.
WhyNot needs_shown_surface(const Editor& editor, bool curves = false);
/// The active polyhedron with something selected of the kinds asked for.
struct NeededElements {
  bool vertices = false, edges = false, faces = false;

  /// Whether a selection has some of them.
  bool among(const ElementSelection& selection) const;
  /// The sentence where it has none.
  const char* missing() const;
};
WhyNot needs_elements(const Editor& editor, NeededElements kinds);
/// The reason of `first`, and else the sentence `otherwise`, unless `holds`.
WhyNot only_if(std::function<bool()> holds, const char* otherwise);
WhyNot only_if(WhyNot first, std::function<bool()> holds, const char* otherwise);

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
/// Adds the commands that take objects of patches apart and put them together.
void add_patch_commands(CommandHost& host);
void add_skin_commands(CommandHost& host);
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

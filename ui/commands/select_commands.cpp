// Commands that choose elements.

#include "core/document/edits.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/icons.hpp"

namespace hariko {

void add_select_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const auto mode = [&](const char* id, const char* label, const char* keys, const char* symbol,
                        ElementMode value) {
    table.add({id,
               "Select",
               label,
               "What a click takes.",
               keys,
               symbol,
               false,
               false,
               [&editor, value] { editor.mode = value; },
               {},
               [&editor, value] { return editor.mode == value; }});
  };
  mode("select.vertices", "Vertices", "1", icon::vertex, ElementMode::vertex);
  mode("select.edges", "Edges", "2", icon::edge, ElementMode::edge);
  mode("select.faces", "Faces", "3", icon::face, ElementMode::face);
  mode("select.objects", "Objects", "4", icon::object, ElementMode::object);
  table.add({"select.all", "Select", "All", "Select every element of the active object.", "Ctrl+A", "", false,
             true, [&editor] { editor.selection.select_all(*editor.active_object(), editor.mode); },
             needs_object(editor)});
  table.add({"select.none", "Select", "None", "Select nothing.", "Ctrl+Shift+A", "", false, false,
             [&editor] { editor.selection.clear_elements(); }});
}

}  // namespace hariko

// Undo and redo.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

void add_edit_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  table.add({"edit.undo", "Edit", "Undo", "Take back the last step.", "Ctrl+Z", icon::undo, true, false,
             [&editor] { editor.undo(); },
             [&editor]() -> std::optional<std::string> {
               if (editor.history.can_undo()) return {};
               return translatable("There is nothing to undo.");
             }});
  table.add({"edit.redo", "Edit", "Redo", "Make the step again that was taken back.", "Ctrl+Shift+Z / Ctrl+Y",
             icon::redo, true, false, [&editor] { editor.redo(); },
             [&editor]() -> std::optional<std::string> {
               if (editor.history.can_redo()) return {};
               return translatable("There is nothing to redo.");
             }});
}

}  // namespace hariko

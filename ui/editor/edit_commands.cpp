// Undo and redo.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

void add_edit_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  table.add({.id = "edit.undo",
             .menu = "Edit",
             .label = "Undo",
             .help = "Take back the last step.",
             .keys = "Ctrl+Z",
             .icon = icon::undo,
             .changes_document = true,
             .run = [&editor] { editor.undo(); },
             .why_not = only_if([&editor] { return editor.history.can_undo(); },
                                translatable("There is nothing to undo."))});
  table.add({.id = "edit.redo",
             .menu = "Edit",
             .label = "Redo",
             .help = "Make the step again that was taken back.",
             .keys = "Ctrl+Shift+Z / Ctrl+Y",
             .icon = icon::redo,
             .changes_document = true,
             .run = [&editor] { editor.redo(); },
             .why_not = only_if([&editor] { return editor.history.can_redo(); },
                                translatable("There is nothing to redo."))});
}

}  // namespace hariko

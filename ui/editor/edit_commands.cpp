// Undo, redo and repeating.

#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"

namespace hariko {

namespace {

Reason nothing_to_repeat(const Editor& editor, const CommandTable& table) {
  if (auto reason = needs_document(editor)()) return reason;
  const LastOperation& last = editor.last_operation;
  if (!last.can_repeat(editor)) return translatable("The last step is none that can be repeated.");
  const Command* command = table.find(last.command());
  return command && command->why_not ? command->why_not() : std::nullopt;
}

void repeat_last(Editor& editor, const CommandTable& table) {
  if (const Command* command = table.find(editor.last_operation.command()))
    table.run(*command);
  else
    editor.last_operation.repeat(editor);
}

}  // namespace

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
  table.add({.id = "edit.repeat",
             .menu = "Edit",
             .label = "Repeat last",
             .help = "Make the last step again, with its numbers, on what is selected now.",
             .keys = "Shift+R",
             .changes_document = true,
             .needs_window = true,
             .run = [&editor, &table] { repeat_last(editor, table); },
             .why_not = [&editor, &table] { return nothing_to_repeat(editor, table); }});
}

}  // namespace hariko

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
  MenuRows rows(host.table, "Edit");
  rows.add_edit(
      "edit.undo", "Undo", "Take back the last step.", [&editor] { editor.undo(); },
      only_if([&editor] { return editor.history.can_undo(); }, translatable("There is nothing to undo.")),
      {.keys = "Ctrl+Z", .icon = icon::undo});
  rows.add_edit(
      "edit.redo", "Redo", "Make the step again that was taken back.", [&editor] { editor.redo(); },
      only_if([&editor] { return editor.history.can_redo(); }, translatable("There is nothing to redo.")),
      {.keys = "Ctrl+Shift+Z / Ctrl+Y", .icon = icon::redo});
  rows.add_edit(
      "edit.repeat", "Repeat last", "Make the last step again, with its numbers, on what is selected now.",
      [&editor, &table] { repeat_last(editor, table); },
      [&editor, &table] { return nothing_to_repeat(editor, table); },
      {.keys = "Shift+R", .needs_window = true});
}

}  // namespace hariko

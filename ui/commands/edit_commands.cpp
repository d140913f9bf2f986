// Commands of the Edit menu: undo, redo, and whole objects.

#include "core/document/edits.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/icons.hpp"

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
  const WhyNot object = needs_object(editor);
  table.add({"object.duplicate", "Edit", "Duplicate object", "Copy the active object in place.", "Ctrl+D", "",
             true, true,
             [&editor] {
               const auto added = duplicate_object(editor.history.current(), editor.selection.active);
               if (!added.ok()) return editor.notify(added.error());
               editor.commit(added->document, "Duplicate object");
               editor.selection.clear_elements();
               editor.selection.active = added->id;
             },
             object});
  table.add({"object.delete", "Edit", "Delete object", "Delete the active object.", "", icon::trash, true,
             false,
             [&editor] {
               const ObjectId id = editor.selection.active;
               editor.commit(delete_objects(editor.history.current(), {&id, 1}), "Delete object");
             },
             object});
}

}  // namespace hariko

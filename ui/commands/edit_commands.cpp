// Commands of the Edit menu: undo, redo, and whole objects.

#include "core/document/edits.hpp"
#include "ui/commands/command_host.hpp"
#include "ui/icons.hpp"
#include "ui/tools/transform_target.hpp"

namespace hariko {

namespace {

/// The copies are selected instead of their originals.
void duplicate_selected(Editor& editor) {
  const auto ids = selected_objects(editor);
  Document document = editor.history.current();
  std::vector<ObjectId> copies;
  for (const ObjectId id : ids) {
    const auto added = duplicate_object(document, id);
    if (!added.ok()) return editor.notify(added.error());
    document = added->document;
    copies.push_back(added->id);
  }
  editor.commit(document, ids.size() == 1 ? "Duplicate object" : "Duplicate objects");
  editor.selection.clear_elements();
  editor.selection.clear_objects();
  for (const ObjectId id : copies) editor.selection.select({id, element_of(id)}, Selection::How::add);
}

}  // namespace

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
  const WhyNot objects = [&editor]() -> Reason {
    if (auto reason = needs_object(editor)()) return reason;
    if (!selected_objects(editor).empty()) return {};
    return translatable("No object is selected. Click one.");
  };
  table.add({"object.duplicate", "Edit", "Duplicate object", "Copy the selected objects in place.", "Ctrl+D",
             "", true, true, [&editor] { duplicate_selected(editor); }, objects});
  table.add({"object.delete", "Edit", "Delete object", "Delete the selected objects.", "Del", icon::trash,
             true, false,
             [&editor] {
               const auto ids = selected_objects(editor);
               editor.commit(delete_objects(editor.history.current(), ids),
                             ids.size() == 1 ? "Delete object" : "Delete objects");
             },
             objects});
}

}  // namespace hariko

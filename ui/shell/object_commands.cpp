// Commands on whole objects: name, visibility, lock, order, copies. They act on all that are chosen.

#include <algorithm>

#include "core/document/edits/edits.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/named_objects.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

std::string counted_step(const char* one, const char* many, std::size_t count) {
  return count == 1 ? one : fill(many, {std::to_string(count)});
}

/// One edit after the other, as one step; nothing happens when one is refused.
template <class Ids, class Edit>
void edit_each(Editor& editor, const Ids& ids, const std::string& step, const Edit& edit) {
  Result<Document> result = editor.history.current();
  for (const ObjectId id : ids)
    if (result.ok()) result = edit(*result, id);
  editor.commit(result, step);
}

void duplicate(Editor& editor) {
  const auto ids = chosen_ids(editor);
  const auto added = duplicate_objects(editor.history.current(), ids);
  if (!added) return editor.notify(added.error());
  editor.commit(added->document, counted_step("Duplicate object", "Duplicate {0} objects", ids.size()));
  choose_objects(editor, added->ids);
}

void isolate(Editor& editor) {
  const auto ids = chosen_ids(editor);
  editor.commit(showing_only(editor.history.current(), ids),
                counted_step("Isolate object", "Isolate {0} objects", ids.size()));
}

void hide_chosen(Editor& editor) {
  const auto ids = chosen_ids(editor);
  edit_each(editor, ids, counted_step("Hide object", "Hide {0} objects", ids.size()),
            [](const Document& document, ObjectId id) { return set_visible(document, id, false); });
}

bool any_hidden(const Editor& editor) {
  const auto& objects = editor.document().objects;
  return std::any_of(objects.begin(), objects.end(), [](const auto& object) { return !object->visible; });
}

void show_hidden(Editor& editor) {
  std::vector<ObjectId> hidden;
  for (const auto& object : editor.history.current().objects)
    if (!object->visible) hidden.push_back(object->id);
  editor.commit(show_objects(editor.history.current(), hidden), "Show all objects");
}

void show_named(Editor& editor, const std::vector<std::string>& names) {
  const auto ids = objects_named(editor.history.current(), names);
  if (!ids) return editor.notify(ids.error());
  editor.commit(show_objects(editor.history.current(), *ids),
                counted_step("Show object", "Show {0} objects", ids->size()));
}

void lock_chosen(Editor& editor, bool lock) {
  const auto ids = chosen_ids(editor);
  edit_each(editor, ids,
            lock ? counted_step("Lock object", "Lock {0} objects", ids.size())
                 : counted_step("Unlock object", "Unlock {0} objects", ids.size()),
            [lock](const Document& document, ObjectId id) { return set_locked(document, id, lock); });
}

void delete_chosen(Editor& editor) {
  const auto ids = chosen_ids(editor);
  const std::size_t attached = attached_to(editor.history.current(), ids);
  if (!editor.commit(delete_objects(editor.history.current(), ids),
                     counted_step("Delete object", "Delete {0} objects", ids.size())))
    return;
  if (attached > 0)
    editor.notify(Notice::Kind::info,
                  fill(editor.language("Attached edges that keep a copy of their side: {0}"),
                       {std::to_string(attached)}));
}

/// All chosen objects one place up or down.
void move_in_order(Editor& editor, bool down) {
  const auto ids = chosen_ids(editor);
  const Document& document = editor.history.current();
  const GroupId group = editor.chosen_group.chosen(editor);
  const Member inside = group == GroupId{} ? Member(ids.front()) : Member(group);
  editor.commit(shift_members(document, GroupTree(document).members_of(ids, inside), down),
                "Reorder objects");
}

WhyNot needs_others(const Editor& editor) {
  return only_if(
      needs_object(editor), [&editor] { return editor.document().objects.size() > 1; },
      translatable("There is no other object."));
}

void add_visibility_commands(CommandTable& table, Editor& editor, const WhyNot& object) {
  table.add({.id = "object.hide",
             .menu = "Edit",
             .label = "Hide",
             .help = "Hide the chosen objects.",
             .keys = "H",
             .icon = icon::hidden,
             .changes_document = true,
             .separator_before = true,
             .run = [&editor] { hide_chosen(editor); },
             .why_not = object,
             .contexts = Context::object});
  table.add({.id = "object.isolate",
             .menu = "Edit",
             .label = "Isolate",
             .help = "Hide all other objects.",
             .keys = "Shift+H",
             .changes_document = true,
             .run = [&editor] { isolate(editor); },
             .why_not = needs_others(editor),
             .contexts = Context::object});
  table.add(
      {.id = "object.show_all",
       .menu = "Edit",
       .label = "Show all",
       .help = "Show every object again.",
       .keys = "Alt+H",
       .icon = icon::shown,
       .changes_document = true,
       .run = [&editor] { show_hidden(editor); },
       .why_not = only_if([&editor] { return any_hidden(editor); }, translatable("No object is hidden.")),
       .script = {.arguments = {optional(list_argument("names", translatable("Objects")))},
                  .run = [&editor](const Arguments& given) {
                    given.has("names") ? show_named(editor, given.list("names")) : show_hidden(editor);
                  }}});
  table.add({.id = "object.lock",
             .menu = "Edit",
             .label = "Lock",
             .help = "Protect the chosen objects from changes, or unlock them.",
             .icon = icon::locked,
             .changes_document = true,
             // Unlocks where the active object is locked.
             .run = [&editor] { lock_chosen(editor, !editor.active_object()->locked); },
             .why_not = object,
             .checked = [&editor] { return editor.active_object() && editor.active_object()->locked; },
             .contexts = Context::object,
             .script = {.arguments = {on_off_argument("on", translatable("Lock"), true)},
                        .run = [&editor](const Arguments& given) { lock_chosen(editor, given.on("on")); },
                        .read =
                            [](const Object& object) {
                              return std::vector{written_switch("on", object.locked_itself())};
                            }}});
}

void add_order_commands(CommandTable& table, Editor& editor) {
  table.add({.id = "object.move_up",
             .menu = "Edit",
             .label = "Move up in the list",
             .help = "One place up in the list of objects.",
             .changes_document = true,
             .separator_before = true,
             .run = [&editor] { move_in_order(editor, false); },
             .why_not = needs_others(editor)});
  table.add({.id = "object.move_down",
             .menu = "Edit",
             .label = "Move down in the list",
             .help = "One place down in the list of objects.",
             .changes_document = true,
             .run = [&editor] { move_in_order(editor, true); },
             .why_not = needs_others(editor)});
}

}  // namespace

void add_object_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot object = needs_object(editor);
  table.add(
      {.id = "object.rename",
       .menu = "Edit",
       .label = "Rename object",
       .help = "Type another name.",
       .keys = "F2",
       .separator_before = true,
       .needs_window = true,
       .run = [&editor] { editor.rename_wanted = true; },
       .why_not = object,
       .contexts = Context::object,
       .script = {.arguments = {text_argument("name", translatable("Name"))},
                  .run =
                      [&editor](const Arguments& given) {
                        editor.commit(rename_object(editor.history.current(), editor.selection.active,
                                                    given.text("name")),
                                      "Rename object");
                      },
                  .read = [](const Object& object) { return std::vector{written("name", object.name)}; }}});
  table.add({.id = "object.duplicate",
             .menu = "Edit",
             .label = "Duplicate object",
             .help = "Copy the chosen objects in place.",
             .keys = "Ctrl+D",
             .changes_document = true,
             .run = [&editor] { duplicate(editor); },
             .why_not = object,
             .contexts = Context::object});
  table.add({.id = "object.delete",
             .menu = "Edit",
             .label = "Delete object",
             .help = "Delete the chosen objects.",
             .keys = "Shift+Del",
             .icon = icon::trash,
             .changes_document = true,
             .run = [&editor] { delete_chosen(editor); },
             .why_not = object});
  add_visibility_commands(table, editor, object);
  add_order_commands(table, editor);
}

}  // namespace hariko

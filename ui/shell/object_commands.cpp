// Commands on whole objects: name, visibility, lock, order, copies, groups. They act on all that are chosen.

#include <algorithm>

#include "core/document/edits/edit_groups.hpp"
#include "core/document/edits/edits.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/chosen_group.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

namespace {

Phrase counted_step(const char* one, const char* many, std::size_t count) {
  return Phrase::counted(count, one, many);
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
  editor.commit(hide_objects(editor.history.current(), ids),
                counted_step("Hide object", "Hide {0} objects", ids.size()));
}

bool any_hidden(const Editor& editor) {
  return std::ranges::any_of(editor.document().objects, [](const auto& object) { return !object->visible; });
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
  editor.commit(lock_objects(editor.history.current(), ids, lock),
                lock ? counted_step("Lock object", "Lock {0} objects", ids.size())
                     : counted_step("Unlock object", "Unlock {0} objects", ids.size()));
}

void delete_chosen(Editor& editor) {
  const auto ids = chosen_ids(editor);
  const std::size_t attached = attached_to(editor.history.current(), ids);
  if (!editor.commit(delete_objects(editor.history.current(), ids),
                     counted_step("Delete object", "Delete {0} objects", ids.size())))
    return;
  if (attached > 0)
    editor.inform({"Attached edges that keep a copy of their side: {0}", {std::to_string(attached)}});
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
  MenuRows rows(table, "Edit");
  rows.add_edit("object.hide", "Hide", "Hide the chosen objects.", [&editor] { hide_chosen(editor); }, object,
                {.keys = "H", .icon = icon::hidden, .separator_before = true, .contexts = Context::object});
  rows.add_edit("object.isolate", "Isolate", "Hide all other objects.", [&editor] { isolate(editor); },
                needs_others(editor), {.keys = "Shift+H", .contexts = Context::object});
  rows.add_edit("object.show_all", "Show all", "Show every object again.", [&editor] { show_hidden(editor); },
                only_if([&editor] { return any_hidden(editor); }, translatable("No object is hidden.")),
                {.keys = "Alt+H",
                 .icon = icon::shown,
                 .script = {.arguments = {optional(list_argument("names", translatable("Objects")))},
                            .run = [&editor](const Arguments& given) {
                              given.has("names") ? show_named(editor, given.list("names"))
                                                 : show_hidden(editor);
                            }}});
  // Unlocks where the active object is locked.
  rows.add_edit(
      "object.lock", "Lock", "Protect the chosen objects from changes, or unlock them.",
      [&editor] { lock_chosen(editor, !editor.active_object()->locked); }, object,
      {.icon = icon::locked,
       .checked = [&editor] { return editor.active_object() && editor.active_object()->locked; },
       .contexts = Context::object,
       .script = {
           .arguments = {on_off_argument("on", translatable("Lock"), true)},
           .run = [&editor](const Arguments& given) { lock_chosen(editor, given.on("on")); },
           .read = [](const Object& of) { return std::vector{written_switch("on", of.locked_itself())}; }}});
}

void add_order_commands(CommandTable& table, Editor& editor) {
  MenuRows rows(table, "Edit");
  rows.add_edit("object.move_up", "Move up in the list", "One place up in the list of objects.",
                [&editor] { move_in_order(editor, false); }, needs_others(editor),
                {.separator_before = true});
  rows.add_edit(
      "object.move_down", "Move down in the list", "One place down in the list of objects.",
      [&editor] { move_in_order(editor, true); }, needs_others(editor));
}

}  // namespace

void add_object_commands(CommandHost& host) {
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const WhyNot object = needs_object(editor);
  MenuRows rows(host.table, "Edit");
  rows.add(
      "object.rename", "Rename object", "Type another name.", [&editor] { editor.rename_wanted = true; },
      object,
      {.keys = "F2",
       .separator_before = true,
       .needs_window = true,
       .contexts = Context::object,
       .script = {.arguments = {text_argument("name", translatable("Name"))},
                  .run =
                      [&editor](const Arguments& given) {
                        editor.commit(rename_object(editor.history.current(), editor.selection.active,
                                                    given.text("name")),
                                      "Rename object");
                      },
                  .read = [](const Object& object) { return std::vector{written("name", object.name)}; }}});
  rows.add_edit("object.duplicate", "Duplicate object", "Copy the chosen objects in place.",
                [&editor] { duplicate(editor); }, object, {.keys = "Ctrl+D", .contexts = Context::object});
  rows.add_edit("object.delete", "Delete object", "Delete the chosen objects.",
                [&editor] { delete_chosen(editor); }, object, {.keys = "Shift+Del", .icon = icon::trash});
  add_visibility_commands(table, editor, object);
  add_order_commands(table, editor);
}

namespace {

void group_chosen(Editor& editor, const std::string& name) {
  const auto added = make_group(editor.history.current(), chosen_ids(editor), name);
  if (!added) return editor.notify(added.error());
  if (editor.commit(added->document, "Group objects")) editor.chosen_group.choose(editor, added->id);
}

void ungroup_chosen(Editor& editor) {
  const auto ids = chosen_ids(editor);
  if (editor.commit(ungroup(editor.history.current(), chosen_groups(editor)), "Ungroup"))
    choose_objects(editor, ids);
}

/// Innermost group of the active object that is not chosen as a whole; the outermost one where all are.
GroupId next_group(const Editor& editor) {
  const Object* active = editor.active_object();
  if (!active) return {};
  const Document& document = editor.document();
  const std::vector<GroupId> whole = chosen_groups(editor);
  const GroupTree tree(document);
  GroupId group = active->group;
  while (group != GroupId{}) {
    const bool has_all = std::ranges::any_of(whole, [&](GroupId all) { return tree.is_within(group, all); });
    const GroupId round = find_group(*document.groups, group)->parent;
    if (!has_all || round == GroupId{}) return group;
    group = round;
  }
  return group;
}

}  // namespace

void add_group_commands(CommandHost& host) {
  Editor& editor = host.editor;
  MenuRows rows(host.table, submenu("Edit", translatable("Groups")));
  rows.add_edit(
      "group.make", "Group", "Put the chosen objects into a new group of the list.",
      [&editor] {
        group_chosen(editor, free_group_name(editor.history.current(), editor.language("Group")));
      },
      needs_object(editor),
      {.keys = "Ctrl+G", .icon = icon::folder, .separator_before = true, .contexts = Context::object});
  rows.add_edit("group.dissolve", "Ungroup", "Dissolve the chosen groups; what they contain stays.",
                [&editor] { ungroup_chosen(editor); },
                only_if(
                    needs_object(editor), [&editor] { return !chosen_groups(editor).empty(); },
                    translatable("No group is chosen. Click a group in the list of objects.")),
                {.keys = "Ctrl+Shift+G", .contexts = Context::object});
  rows.add("group.select", "Select group",
           "Select everything in the group of the active object, then the group round it.",
           [&editor] { editor.chosen_group.choose(editor, next_group(editor)); },
           only_if(
               needs_object(editor), [&editor] { return editor.active_object()->group != GroupId{}; },
               translatable("The active object is in no group.")),
           {.contexts = Context::object});
}

}  // namespace hariko

// Commands on groups of objects.

#include <algorithm>

#include "core/document/edits/edit_groups.hpp"
#include "ui/base/icons.hpp"
#include "ui/editor/chosen_group.hpp"
#include "ui/editor/command_host.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

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
  CommandTable& table = host.table;
  Editor& editor = host.editor;
  const std::string menu = submenu("Edit", translatable("Groups"));
  table.add({.id = "group.make",
             .menu = menu,
             .label = "Group",
             .help = "Put the chosen objects into a new group of the list.",
             .keys = "Ctrl+G",
             .icon = icon::folder,
             .changes_document = true,
             .separator_before = true,
             .run =
                 [&editor] {
                   group_chosen(editor, free_group_name(editor.history.current(), editor.language("Group")));
                 },
             .why_not = needs_object(editor),
             .contexts = Context::object});
  table.add({.id = "group.dissolve",
             .menu = menu,
             .label = "Ungroup",
             .help = "Dissolve the chosen groups; what they contain stays.",
             .keys = "Ctrl+Shift+G",
             .changes_document = true,
             .run = [&editor] { ungroup_chosen(editor); },
             .why_not = only_if(
                 needs_object(editor), [&editor] { return !chosen_groups(editor).empty(); },
                 translatable("No group is chosen. Click a group in the list of objects.")),
             .contexts = Context::object});
  table.add({.id = "group.select",
             .menu = menu,
             .label = "Select group",
             .help = "Select everything in the group of the active object, then the group round it.",
             .run = [&editor] { editor.chosen_group.choose(editor, next_group(editor)); },
             .why_not = only_if(
                 needs_object(editor), [&editor] { return editor.active_object()->group != GroupId{}; },
                 translatable("The active object is in no group.")),
             .contexts = Context::object});
}

}  // namespace hariko

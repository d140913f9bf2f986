#include "ui/editor/chosen_group.hpp"

#include "core/document/group_tree.hpp"
#include "ui/editor/editor.hpp"
#include "ui/editor/selected_items.hpp"

namespace hariko {

void ChosenGroup::choose(Editor& editor, GroupId group) {
  choose_objects(editor, GroupTree(editor.document()).objects_in(group));
  chosen_ = Chosen{group, editor.selection, editor.mode};
}

GroupId ChosenGroup::chosen(const Editor& editor) const {
  if (!chosen_ || !(chosen_->selection == editor.selection) || chosen_->mode != editor.mode) return {};
  return find_group(*editor.document().groups, chosen_->group) ? chosen_->group : GroupId{};
}

std::vector<GroupId> chosen_groups(const Editor& editor) {
  std::vector<GroupId> out;
  if (editor.document().groups->empty()) return out;
  for (const Member& member : GroupTree(editor.document()).members_of(chosen_ids(editor)))
    if (const GroupId* group = std::get_if<GroupId>(&member)) out.push_back(*group);
  return out;
}

}  // namespace hariko

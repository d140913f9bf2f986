#include "core/document/edits/edit_groups.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "core/document/edits/edit_support.hpp"

namespace hariko {

namespace {

Message unknown_group() {
  return make_error(e_unknown_group, "The document has no such group.", "Choose a group of the document.");
}

Message locked_group(const Document& document, GroupId id) {
  const Group* group = find_group(*document.groups, id);
  // The name is that of the group whose own switch it is.
  while (!group->locked) group = find_group(*document.groups, group->parent);
  return make_error(e_locked, "The group \"" + group->name + "\" is locked.", "Unlock it first.");
}

Result<Done> check_members(const GroupTree& tree, std::span<const Member> members) {
  for (const Member& member : members) {
    if (tree.contains(member)) continue;
    if (const ObjectId* object = std::get_if<ObjectId>(&member)) return detail::unknown_object(*object);
    return unknown_group();
  }
  return Done{};
}

/// Refuses members that would enter or leave a locked group.
Result<Done> check_unlocked(const Document& document, const GroupTree& tree, std::span<const Member> members,
                            GroupId into) {
  for (const Member& member : members) {
    const GroupId from = tree.group_of(member);
    if (from == into) continue;
    for (const GroupId group : {from, into})
      if (is_locked(document, group)) return locked_group(document, group);
  }
  return Done{};
}

/// Leaves out what lies in another given member.
std::vector<Member> outermost(const GroupTree& tree, std::span<const Member> members) {
  std::set<Member> given(members.begin(), members.end());
  std::vector<Member> out;
  for (const Member& member : given) {
    GroupId at = tree.group_of(member);
    while (at != GroupId{} && !given.contains(at)) at = tree.group_of(at);
    if (at == GroupId{}) out.push_back(member);
  }
  return out;
}

Result<Document> applied(const GroupTree& tree, const Document& document, Groups groups) {
  if (tree.depth() > Group::max_depth)
    return make_error(e_group_depth, "The groups would lie too deep in each other.",
                      "Nest at most " + std::to_string(Group::max_depth) + " groups.");
  return tree.applied(document, std::move(groups));
}

/// Innermost group that contains all of the members and is none of them.
GroupId common_group(const GroupTree& tree, std::span<const Member> members) {
  GroupId common = tree.group_of(members.front());
  const auto holds = [&](const Member& member) { return tree.is_within(tree.group_of(member), common); };
  while (common != GroupId{} && !std::ranges::all_of(members, holds)) common = tree.group_of(common);
  return common;
}

/// Member of `group` that contains another member, or is it.
Member child_towards(const GroupTree& tree, Member member, GroupId group) {
  while (tree.group_of(member) != group) member = tree.group_of(member);
  return member;
}

Result<Document> change_group(const Document& document, GroupId id,
                              const std::function<Result<Done>(Group&)>& change) {
  if (!find_group(*document.groups, id)) return unknown_group();
  Groups groups = *document.groups;
  Group& group = *std::ranges::find(groups, id, &Group::id);
  if (const auto done = change(group); !done) return done.error();
  if (groups == *document.groups) return document;
  Document result = document;
  result.groups = std::move(groups);
  return with_group_switches(result);
}

/// Hides members by their own switches.
void hide_members(Document& document, Groups& groups, std::span<const Member> members) {
  const std::set<Member> hidden(members.begin(), members.end());
  for (Group& group : groups)
    if (hidden.contains(group.id)) group.visible = false;
  for (auto& object : document.objects) {
    if (!hidden.contains(object->id) || !object->visible_itself()) continue;
    Object changed = *object;
    changed.visible = changed.hidden_by_group = false;
    object = std::make_shared<const Object>(std::move(changed));
  }
}

}  // namespace

Result<AddedGroup> make_group(const Document& document, std::span<const ObjectId> objects, std::string name) {
  if (const auto checked = check_name(name); !checked) return checked.error();
  if (objects.empty())
    return make_error(e_group_empty, "There is nothing to group.", "Select one or more objects.");
  GroupTree tree(document);
  const std::vector<Member> given(objects.begin(), objects.end());
  if (const auto checked = check_members(tree, given); !checked) return checked.error();
  const std::vector<Member> members = tree.members_of(objects);
  const GroupId round = common_group(tree, members);
  if (is_locked(document, round)) return locked_group(document, round);
  if (const auto checked = check_unlocked(document, tree, members, round); !checked) return checked.error();
  Groups groups = *document.groups;
  Group added{next_group_id(groups), std::move(name), round, true, false, {}};
  const GroupId id = added.id;
  tree.add(id, {round, child_towards(tree, members.front(), round)});
  tree.move(members, {id, {}});
  groups.insert(std::ranges::lower_bound(groups, id, {}, &Group::id), std::move(added));
  auto result = applied(tree, document, std::move(groups));
  if (!result) return result.error();
  return AddedGroup{std::move(result).value(), id};
}

Result<Document> ungroup(const Document& document, std::span<const GroupId> groups) {
  Document changed = document;
  Groups all = *document.groups;
  GroupTree tree(document);
  for (const GroupId id : groups) {
    if (!tree.contains(id)) return unknown_group();
    if (is_locked(document, id)) return locked_group(document, id);
  }
  for (const GroupId id : std::set<GroupId>(groups.begin(), groups.end())) {
    const std::vector<Member> members(tree.members(id).begin(), tree.members(id).end());
    if (!std::ranges::find(all, id, &Group::id)->visible) hide_members(changed, all, members);
    tree.move(members, {tree.group_of(id), id});
  }
  return tree.applied(changed, std::move(all));
}

Result<Document> move_members(const Document& document, std::span<const Member> members,
                              const MemberPlace& place) {
  GroupTree tree(document);
  if (const auto checked = check_members(tree, members); !checked) return checked.error();
  if (place.group != GroupId{} && !tree.contains(place.group)) return unknown_group();
  if (place.before && (!tree.contains(*place.before) || tree.group_of(*place.before) != place.group))
    return unknown_group();
  const std::vector<Member> moved = outermost(tree, members);
  for (const Member& member : moved)
    if (const GroupId* group = std::get_if<GroupId>(&member); group && tree.is_within(place.group, *group))
      return make_error(e_group_cycle, "A group cannot lie in itself.", "Drop it outside of itself.");
  if (const auto checked = check_unlocked(document, tree, moved, place.group); !checked)
    return checked.error();
  tree.move(moved, place);
  return applied(tree, document, *document.groups);
}

Result<Document> shift_members(const Document& document, std::span<const Member> members, bool down) {
  GroupTree tree(document);
  if (const auto checked = check_members(tree, members); !checked) return checked.error();
  std::map<GroupId, std::vector<Member>> by_group;
  for (const Member& member : outermost(tree, members)) by_group[tree.group_of(member)].push_back(member);
  for (const auto& entry : by_group) {
    const GroupId group = entry.first;
    const std::vector<Member>& moved = entry.second;
    const std::vector<Member> rows(tree.members(group).begin(), tree.members(group).end());
    const auto is_moved = [&](const Member& row) {
      return std::find(moved.begin(), moved.end(), row) != moved.end();
    };
    const auto first = static_cast<std::size_t>(std::ranges::find_if(rows, is_moved) - rows.begin());
    std::size_t last = rows.size() - 1;
    while (!is_moved(rows[last])) --last;
    const std::size_t at = down ? last + 2 : first - std::min<std::size_t>(first, 1);
    tree.move(moved, {group, at < rows.size() ? std::optional(rows[at]) : std::nullopt});
  }
  return tree.applied(document, *document.groups);
}

Result<Document> rename_group(const Document& document, GroupId group, std::string name) {
  return change_group(document, group, [&](Group& changed) -> Result<Done> {
    if (const auto checked = check_name(name); !checked) return checked.error();
    changed.name = std::move(name);
    return Done{};
  });
}

Result<Document> set_group_visible(const Document& document, GroupId group, bool visible) {
  return change_group(document, group, [&](Group& changed) -> Result<Done> {
    changed.visible = visible;
    return Done{};
  });
}

Result<Document> set_group_locked(const Document& document, GroupId group, bool locked) {
  return change_group(document, group, [&](Group& changed) -> Result<Done> {
    changed.locked = locked;
    return Done{};
  });
}

Result<Document> set_group_colour(const Document& document, GroupId group, std::optional<Colour> colour) {
  return change_group(document, group, [&](Group& changed) -> Result<Done> {
    changed.colour = colour;
    return Done{};
  });
}

Result<Document> show_objects(const Document& document, std::span<const ObjectId> objects) {
  const std::set<ObjectId> shown(objects.begin(), objects.end());
  Document result = document;
  std::set<GroupId> round;
  std::size_t found = 0;
  for (auto& object : result.objects) {
    if (!shown.contains(object->id)) continue;
    ++found;
    round.insert(object->group);
    if (object->visible_itself()) continue;
    Object changed = *object;
    changed.visible = true;
    object = std::make_shared<const Object>(std::move(changed));
  }
  for (const ObjectId id : shown)
    if (found < shown.size() && !document.find(id)) return detail::unknown_object(id);
  Groups groups = *document.groups;
  for (const GroupId id : round)
    for (auto at = std::ranges::find(groups, id, &Group::id); at != groups.end();
         at = std::ranges::find(groups, at->parent, &Group::id))
      at->visible = true;
  if (groups != *document.groups) result.groups = std::move(groups);
  return with_group_switches(result);
}

Document without_empty_groups(const Document& document) {
  if (document.groups->empty()) return document;
  const GroupTree tree(document);
  Groups groups = *document.groups;
  if (std::erase_if(groups, [&](const Group& group) { return !tree.contains(group.id); }) == 0)
    return document;
  Document result = document;
  result.groups = std::move(groups);
  return result;
}

GroupId unlocked_group(const Document& document, GroupId group) {
  while (is_locked(document, group)) group = find_group(*document.groups, group)->parent;
  return group;
}

std::string free_group_name(const Document& document, const std::string& name) {
  std::set<std::string> taken;
  for (const Group& group : *document.groups) taken.insert(group.name);
  std::string free = name;
  for (std::size_t number = 2; taken.contains(free); ++number)
    free = detail::name_with(name, " " + std::to_string(number));
  return free;
}

}  // namespace hariko

#include "core/document/group_tree.hpp"

#include <algorithm>

namespace hariko {

GroupTree::GroupTree(const Document& document) {
  const Groups& groups = *document.groups;
  for (const auto& object : document.objects) {
    Member member = object->id;
    GroupId group = find_group(groups, object->group) ? object->group : GroupId{};
    // Groups above stand where their first object does.
    while (parents_.emplace(member, group).second) {
      members_[group].push_back(member);
      if (group == GroupId{}) break;
      member = group;
      group = find_group(groups, group)->parent;
    }
  }
}

std::span<const Member> GroupTree::members(GroupId group) const {
  const auto found = members_.find(group);
  return found == members_.end() ? std::span<const Member>{} : found->second;
}

bool GroupTree::is_within(const Member& member, GroupId group) const {
  Member at = member;
  while (true) {
    if (at == Member(group)) return true;
    const GroupId* id = std::get_if<GroupId>(&at);
    if (id && *id == GroupId{}) return false;
    at = group_of(at);
  }
}

void GroupTree::visit(GroupId group, std::vector<ObjectId>& objects) const {
  for (const Member& member : members(group))
    if (const ObjectId* object = std::get_if<ObjectId>(&member))
      objects.push_back(*object);
    else
      visit(std::get<GroupId>(member), objects);
}

std::vector<ObjectId> GroupTree::objects_in(GroupId group) const {
  std::vector<ObjectId> out;
  visit(group, out);
  return out;
}

std::vector<Member> GroupTree::in_order(std::span<const Member> given) const {
  const std::set<Member> chosen(given.begin(), given.end());
  std::vector<Member> out;
  const auto walk = [&](const auto& self, GroupId group) -> void {
    for (const Member& member : members(group)) {
      if (chosen.contains(member)) out.push_back(member);
      if (const GroupId* inner = std::get_if<GroupId>(&member)) self(self, *inner);
    }
  };
  walk(walk, GroupId{});
  return out;
}

std::vector<Member> GroupTree::members_of(std::span<const ObjectId> objects,
                                          const std::optional<Member>& inside) const {
  const std::set<ObjectId> chosen(objects.begin(), objects.end());
  // Members of a group that are given as a whole; all of them: the group itself may stand for them.
  const auto walk = [&](const auto& self, GroupId group, std::vector<Member>& out) -> bool {
    bool all = true;
    for (const Member& member : members(group)) {
      if (const ObjectId* object = std::get_if<ObjectId>(&member)) {
        if (chosen.contains(*object))
          out.push_back(member);
        else
          all = false;
        continue;
      }
      const GroupId inner = std::get<GroupId>(member);
      std::vector<Member> below;
      const bool whole = self(self, inner, below);
      if (whole && !(inside && is_within(*inside, inner) && *inside != member))
        below = {member};
      else
        all = false;
      out.insert(out.end(), below.begin(), below.end());
    }
    return all;
  };
  std::vector<Member> out;
  walk(walk, GroupId{}, out);
  return out;
}

void GroupTree::move(std::span<const Member> given, const MemberPlace& place) {
  const std::vector<Member> moved = in_order(given);
  HARIKO_ASSERT(moved.size() == std::set<Member>(given.begin(), given.end()).size(), "member of no group");
  std::optional<Member> before = place.before;
  // A mark that moves itself gives way to the next member that stays.
  if (before) {
    const std::span<const Member> siblings = members(place.group);
    auto at = std::find(siblings.begin(), siblings.end(), *before);
    HARIKO_ASSERT(at != siblings.end(), "the mark does not lie in the group");
    while (at != siblings.end() && std::find(moved.begin(), moved.end(), *at) != moved.end()) ++at;
    before = at == siblings.end() ? std::nullopt : std::optional(*at);
  }
  for (const Member& member : moved) {
    const GroupId* group = std::get_if<GroupId>(&member);
    HARIKO_ASSERT(!group || place.group == GroupId{} || !is_within(Member(place.group), *group),
                  "a group cannot lie in itself");
    std::erase(members_[group_of(member)], member);
    parents_[member] = place.group;
  }
  std::vector<Member>& siblings = members_[place.group];
  siblings.insert(before ? std::find(siblings.begin(), siblings.end(), *before) : siblings.end(),
                  moved.begin(), moved.end());
}

void GroupTree::add(GroupId group, const MemberPlace& place) {
  std::vector<Member>& siblings = members_[place.group];
  siblings.insert(place.before ? std::find(siblings.begin(), siblings.end(), *place.before) : siblings.end(),
                  Member(group));
  parents_[Member(group)] = place.group;
}

std::size_t GroupTree::depth_below(GroupId group) const {
  std::size_t deepest = 0;
  for (const Member& member : members(group))
    if (const GroupId* inner = std::get_if<GroupId>(&member); inner && !objects_in(*inner).empty())
      deepest = std::max(deepest, 1 + depth_below(*inner));
  return deepest;
}

Document GroupTree::applied(const Document& document, Groups groups) const {
  std::map<ObjectId, std::shared_ptr<const Object>> objects;
  for (const auto& object : document.objects) objects.emplace(object->id, object);
  Document result = document;
  result.objects.clear();
  std::set<GroupId> used;
  for (const ObjectId id : objects_in(GroupId{})) {
    std::shared_ptr<const Object> object = objects.at(id);
    const GroupId group = group_of(Member(id));
    for (GroupId at = group; at != GroupId{} && used.insert(at).second;) at = group_of(Member(at));
    if (object->group != group) {
      Object changed = *object;
      changed.group = group;
      object = std::make_shared<const Object>(std::move(changed));
    }
    result.objects.push_back(std::move(object));
  }
  std::erase_if(groups, [&](const Group& group) { return !used.contains(group.id); });
  for (Group& group : groups) group.parent = group_of(Member(group.id));
  if (groups != *document.groups) result.groups = std::move(groups);
  return with_group_switches(result);
}

bool is_locked(const Document& document, GroupId id) {
  for (const Group* group = find_group(*document.groups, id); group;
       group = find_group(*document.groups, group->parent))
    if (group->locked) return true;
  return false;
}

bool is_visible(const Document& document, GroupId id) {
  for (const Group* group = find_group(*document.groups, id); group;
       group = find_group(*document.groups, group->parent))
    if (!group->visible) return false;
  return true;
}

Document with_group_switches(const Document& document) {
  Document result = document;
  for (auto& object : result.objects) {
    // An object outside of all groups that none has hidden or locked is as it is.
    if (object->group == GroupId{} && !object->hidden_by_group && !object->locked_by_group) continue;
    const bool visible = object->visible_itself(), locked = object->locked_itself();
    const bool hides = !is_visible(document, object->group), locks = is_locked(document, object->group);
    Object changed = *object;
    changed.hidden_by_group = visible && hides;
    changed.visible = visible && !hides;
    changed.locked_by_group = !locked && locks;
    changed.locked = locked || locks;
    if (!(changed == *object)) object = std::make_shared<const Object>(std::move(changed));
  }
  return result;
}

}  // namespace hariko

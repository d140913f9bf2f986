#include "core/document/group.hpp"

#include <algorithm>

namespace hariko {

const Group* find_group(const Groups& groups, GroupId id) {
  const auto found =
      std::lower_bound(groups.begin(), groups.end(), id, [](const Group& a, GroupId b) { return a.id < b; });
  return found != groups.end() && found->id == id ? &*found : nullptr;
}

GroupId next_group_id(const Groups& groups) {
  if (groups.empty()) return {1};
  if (groups.back().id.value < Group::max_id) return {groups.back().id.value + 1};
  std::uint32_t free = 1;
  for (const Group& group : groups)
    if (group.id.value == free) ++free;
  return {free};
}

std::optional<std::string> group_fault(const Groups& groups) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const std::string name = "the group " + std::to_string(groups[i].id.value);
    if (i > 0 && !(groups[i - 1].id < groups[i].id)) return "the ids of groups must ascend: " + name;
    std::size_t depth = 1;
    for (GroupId at = groups[i].parent; at != GroupId{}; ++depth) {
      const Group* parent = find_group(groups, at);
      if (!parent) return name + " lies in a group that does not exist";
      if (parent->id == groups[i].id) return name + " contains itself";
      // A cycle above the group ends here, too.
      if (depth == Group::max_depth)
        return name + " lies in more than " + std::to_string(Group::max_depth - 1) + " groups";
      at = parent->parent;
    }
  }
  return std::nullopt;
}

}  // namespace hariko

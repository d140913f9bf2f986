#pragma once

// Edits of groups: make, dissolve, name, show, lock, colour, and move rows of the list into and out of them.

#include <span>
#include <string>
#include <vector>

#include "core/document/document.hpp"
#include "core/document/group_tree.hpp"

namespace hariko {

inline constexpr Code e_unknown_group{"E_UNKNOWN_GROUP"};
inline constexpr Code e_group_empty{"E_GROUP_EMPTY"};
inline constexpr Code e_group_cycle{"E_GROUP_CYCLE"};
inline constexpr Code e_group_depth{"E_GROUP_DEPTH"};

/// A document and the group that the edit made.
struct AddedGroup {
  Document document;
  GroupId id;
};

/// Puts objects into a new group, where the first of them stands. It lies in the innermost group that
/// contains all of them; groups whose objects are all given lie in it as they are. Order as in the list.
/// Errors: E_UNKNOWN_OBJECT, E_GROUP_EMPTY (no object), E_GROUP_DEPTH, E_LOCKED (an object leaves a locked
/// group, or the new one would lie in one), E_NAME_EMPTY, E_NAME_INVALID. O(n log n).
Result<AddedGroup> make_group(const Document& document, std::span<const ObjectId> objects, std::string name);

/// Dissolves groups: what they contain takes their place, and what a hidden one contains is then hidden by
/// its own switch. Errors: E_UNKNOWN_GROUP, E_LOCKED. O(n log n).
Result<Document> ungroup(const Document& document, std::span<const GroupId> groups);

/// Moves rows of the list, in their order, to another place, into groups and out of them. A row that lies in
/// another given row comes along with it; groups without objects vanish. Errors: E_UNKNOWN_OBJECT,
/// E_UNKNOWN_GROUP (also where `place.before` does not lie in `place.group`), E_GROUP_CYCLE (a group into
/// itself), E_GROUP_DEPTH, E_LOCKED (a row enters or leaves a locked group). O(n log n).
Result<Document> move_members(const Document& document, std::span<const Member> members,
                              const MemberPlace& place);

/// Moves rows one place up or down among the rows of the group that they lie in; those that stand in the same
/// group come together. At the end of its group a row stays. Errors: E_UNKNOWN_OBJECT, E_UNKNOWN_GROUP.
/// O(n log n).
Result<Document> shift_members(const Document& document, std::span<const Member> members, bool down);

/// Renames a group. Errors: E_UNKNOWN_GROUP, E_NAME_EMPTY, E_NAME_INVALID.
Result<Document> rename_group(const Document& document, GroupId group, std::string name);
/// Shows or hides what a group contains. Errors: E_UNKNOWN_GROUP.
Result<Document> set_group_visible(const Document& document, GroupId group, bool visible);
/// Locks or unlocks what a group contains. Errors: E_UNKNOWN_GROUP.
Result<Document> set_group_locked(const Document& document, GroupId group, bool locked);
/// Sets the colour of a group's mark, or takes it away. Errors: E_UNKNOWN_GROUP.
Result<Document> set_group_colour(const Document& document, GroupId group, std::optional<Colour> colour);

/// Shows objects and all groups round them. Errors: E_UNKNOWN_OBJECT. O(n log n).
Result<Document> show_objects(const Document& document, std::span<const ObjectId> objects);

/// Document without groups that contain no object. Costs nothing where there are no groups.
Document without_empty_groups(const Document& document);

/// Group round `group` (or itself) in which nothing is locked by a group; none where all are.
GroupId unlocked_group(const Document& document, GroupId group);

/// Returns the name where no group has it, else with the lowest free number, as `free_name` does for objects.
std::string free_group_name(const Document& document, const std::string& name);

}  // namespace hariko

#pragma once

// GroupTree: the objects of a document as its groups nest them, for lists and for edits of groups.

#include <map>
#include <set>
#include <span>
#include <variant>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// Row of the list of objects: an object or a group with all that it contains.
using Member = std::variant<ObjectId, GroupId>;

/// Place in the list: in a group (none: outside of all), before one of its members or at its end.
struct MemberPlace {
  GroupId group = {};
  std::optional<Member> before = {};
};

/// Members of each group in their order. An object whose group does not exist counts as lying in none.
class GroupTree {
 public:
  /// O(n log n) in the objects and groups together.
  explicit GroupTree(const Document& document);

  /// Members of a group, those outside of all groups for none.
  std::span<const Member> members(GroupId group) const;
  /// Group that a member lies in; none where it lies in none. The member must exist.
  GroupId group_of(const Member& member) const { return parents_.at(member); }
  bool contains(const Member& member) const { return parents_.contains(member); }
  /// Whether the member is the group, or lies in it at any depth.
  bool is_within(const Member& member, GroupId group) const;
  /// Objects of a group at any depth, in the order of the list; with none, all objects.
  std::vector<ObjectId> objects_in(GroupId group) const;

  /// Members that stand for these objects: a group instead of objects where all of its objects are given, as
  /// far out as possible, though never a group that contains `inside`. In the order of the list. O(n log n).
  std::vector<Member> members_of(std::span<const ObjectId> objects,
                                 const std::optional<Member>& inside = {}) const;

  /// Moves members, in the order of the list, to a place. Asserts that they exist and that no group comes to
  /// lie in itself.
  void move(std::span<const Member> members, const MemberPlace& place);
  /// Adds an empty group at a place.
  void add(GroupId group, const MemberPlace& place);

  /// Levels of groups that contain objects, one within the other; 0 without groups.
  std::size_t depth() const { return depth_below(GroupId{}); }

  /// Document with the order and the groups of this tree: its objects stand in the order of the list, groups
  /// without objects are gone, and the groups' switches are passed on (`with_group_switches`). `groups` are
  /// those of the document and what was added.
  Document applied(const Document& document, Groups groups) const;

 private:
  std::vector<Member> in_order(std::span<const Member> members) const;
  std::size_t depth_below(GroupId group) const;
  void visit(GroupId group, std::vector<ObjectId>& objects) const;

  std::map<GroupId, std::vector<Member>> members_;
  std::map<Member, GroupId> parents_;
};

/// Passes the switches of groups on to the objects: an object in a hidden or locked group has
/// `hidden_by_group` or `locked_by_group`, and the `visible` and `locked` that follow. Objects that stay as
/// they are stay shared. O(n log n).
Document with_group_switches(const Document& document);

/// Whether the group or one that contains it is locked. O(depth).
bool is_locked(const Document& document, GroupId group);
/// Whether the group and all that contain it are visible. O(depth).
bool is_visible(const Document& document, GroupId group);

}  // namespace hariko

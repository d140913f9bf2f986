#pragma once

// Group: objects and other groups under one name, which are shown, hidden and locked together.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/document/display.hpp"

namespace hariko {

/// Name of a group within its document; the default is no group.
struct GroupId {
  std::uint32_t value = 0xffffffffU;
  friend auto operator<=>(const GroupId&, const GroupId&) = default;
};

/// Invariants (kept by the edits, checked by the file reader): the name is one that `check_name` takes, the
/// parent exists, no group contains itself, groups are nested at most `max_depth` deep, and each has an
/// object in it or in a group within it. Place of a group in the list: that of its first object.
struct Group {
  GroupId id;
  std::string name;
  GroupId parent = {};                ///< group that it lies in; none: it lies in no other
  bool visible = true;                ///< its own switch: what it contains is hidden where it is off
  bool locked = false;                ///< its own switch: what it contains is locked where it is on
  std::optional<Colour> colour = {};  ///< colour of its mark in the list

  static constexpr std::size_t max_depth = 16;
  static constexpr std::uint32_t max_id = 0x7fffffffU;

  friend bool operator==(const Group&, const Group&) = default;
};

/// Groups of a document by ascending id.
using Groups = std::vector<Group>;

/// Group with this id; null where there is none. O(log n).
const Group* find_group(const Groups& groups, GroupId id);

/// Id for a new group: above all others, or the lowest free one where that would be too large. O(n).
GroupId next_group_id(const Groups& groups);

/// Sentence about the first group whose id, parent or depth breaks an invariant; none where all hold. Sorts
/// nothing: the ids must ascend. O(n x depth).
std::optional<std::string> group_fault(const Groups& groups);

}  // namespace hariko

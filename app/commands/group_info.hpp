#pragma once

// Report of `hariko info` on the groups of a document.

#include <optional>
#include <string>
#include <vector>

#include "core/document/document.hpp"

namespace hariko {

/// A group with the objects that it contains at any depth, in the order of the list.
struct GroupInfo {
  std::uint32_t id = 0;
  std::string name;
  std::optional<std::uint32_t> parent;  ///< id of the group that it lies in
  bool visible = true, locked = false;  ///< with the groups round it
  std::vector<std::string> objects;     ///< names
};

/// All groups by ascending id. O(n log n).
std::vector<GroupInfo> inspect_groups(const Document& document);

/// Report as text: their number, then a line for each. Empty where there are none.
std::string groups_text(const std::vector<GroupInfo>& groups);

}  // namespace hariko

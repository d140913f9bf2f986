#pragma once

// KeptMembers: members of a file that this program does not know.

#include <string>
#include <vector>

namespace hariko {

/// Unknown member of a file, kept and written back unchanged.
struct KeptMember {
  std::string name;
  std::string json;  ///< text of its value, byte for byte
  friend bool operator==(const KeptMember&, const KeptMember&) = default;
};
using KeptMembers = std::vector<KeptMember>;

}  // namespace hariko

#pragma once

// KeptMembers: what a file has beyond what this program knows.

#include <string>
#include <vector>

namespace hariko {

/// A member of a file that this program does not know: kept, and written back as it was.
struct KeptMember {
  std::string name;
  std::string json;  ///< the text of its value, byte for byte
  friend bool operator==(const KeptMember&, const KeptMember&) = default;
};
using KeptMembers = std::vector<KeptMember>;

}  // namespace hariko

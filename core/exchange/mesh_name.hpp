#pragma once

// Names of meshes in text formats. Internal to core/exchange.

#include <string>
#include <string_view>

#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

/// Name for one line of a text format: no control characters, no backslash (it could join lines), no # (it
/// could start a comment), no blanks at the ends; "object" where nothing is left.
inline std::string name_for_file(std::string_view name) {
  std::string out = sanitized_utf8(name, 200);
  for (char& c : out)
    if (c == '\\' || c == '#') c = '_';
  const std::size_t first = out.find_first_not_of(' ');
  if (first == std::string::npos) return "object";
  return out.substr(first, out.find_last_not_of(' ') - first + 1);
}

}  // namespace hariko

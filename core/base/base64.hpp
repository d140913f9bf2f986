#pragma once

// Base64 (RFC 4648): bytes as text of letters, digits, + and /.

#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// With padding, on one line.
std::string to_base64(std::string_view bytes);

struct Base64Bytes {
  std::string bytes;                 ///< up to the wrong character
  std::optional<std::size_t> wrong;  ///< place of the first character that does not belong there
};
/// Either alphabet (+ and /, or - and _), with or without padding.
Base64Bytes from_base64(std::string_view text);

}  // namespace hariko

#pragma once

// Base64 (RFC 4648): bytes as text of letters, digits, + and /.

#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// Encodes with the alphabet of + and /, with padding, on one line.
std::string to_base64(std::string_view bytes);

/// Result of decoding: the bytes, and where the text is invalid.
struct Base64Bytes {
  std::string bytes;                 ///< decoded bytes, up to the first invalid character
  std::optional<std::size_t> wrong;  ///< offset of the first invalid character
};
/// Decodes either alphabet (+ and /, or - and _), with or without padding.
Base64Bytes from_base64(std::string_view text);

}  // namespace hariko

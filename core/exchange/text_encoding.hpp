#pragma once

// Text files in encodings other than UTF-8. Internal to core/exchange.

#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// Converts UTF-16 text to UTF-8. It is recognised by its byte order mark, or by alternating zero bytes at
/// its beginning; unpaired surrogates become U+FFFD. Nothing for other bytes. O(size).
std::optional<std::string> from_utf16(std::string_view bytes);

}  // namespace hariko

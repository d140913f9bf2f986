#pragma once

// Text files that are no UTF-8. Internal to core/exchange.

#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// UTF-16 text, told by its byte order mark, or by every other one of its first bytes being 0, as UTF-8; half
/// characters become U+FFFD. Nothing for other bytes. O(size).
std::optional<std::string> from_utf16(std::string_view bytes);

}  // namespace hariko

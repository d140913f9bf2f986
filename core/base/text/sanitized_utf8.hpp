#pragma once

// Sanitised text: text of unknown origin (file contents, file names) made fit for messages and JSON.

#include <cstddef>
#include <string>
#include <string_view>

namespace hariko {

/// Sanitised copy of `text`: valid UTF-8 without control characters; each offending byte becomes '?'. Text
/// longer than `limit` bytes is cut at a character boundary and ends in "...". O(min(size, limit)).
std::string sanitized_utf8(std::string_view text, std::size_t limit = 1000);

/// Sanitised copy of a name or token for messages: when longer than `limit` bytes, its middle becomes "...",
/// as names differ at their ends. O(limit).
std::string shortened(std::string_view text, std::size_t limit);

}  // namespace hariko

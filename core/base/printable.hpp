#pragma once

// Text of unknown origin (file contents, file names) made fit for messages and JSON.

#include <cstddef>
#include <string>
#include <string_view>

namespace hariko {

/// `text` as valid UTF-8 without control characters: each offending byte becomes '?'. Longer than `limit`
/// bytes, it is cut at a character boundary and ends in "...". O(min(size, limit)).
std::string printable(std::string_view text, std::size_t limit = 1000);

/// The same for names and tokens in messages: longer than `limit` bytes, its middle becomes "...", as names
/// differ at their ends. O(limit).
std::string shortened(std::string_view text, std::size_t limit);

}  // namespace hariko

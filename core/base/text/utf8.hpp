#pragma once

#include <cstddef>
#include <string_view>

namespace hariko {

/// Length of the well-formed UTF-8 sequence at the start of `text`, 0 when there is none (Unicode 15, table
/// 3-7). `text` is not empty.
std::size_t utf8_length(std::string_view text);

/// Whether a byte is one of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace hariko

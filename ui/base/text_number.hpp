#pragma once

// Numbers from texts that hold nothing else.

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hariko {

/// The finite number that is all of a text; nothing for anything else.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || stop != text.data() + text.size()) return {};
  if constexpr (std::floating_point<Number>)
    if (!std::isfinite(value)) return {};
  return value;
}

/// So many numbers with a separator between them: "1280x960", "1,0,2".
template <class Number, std::size_t count>
std::optional<std::array<Number, count>> numbers_in(std::string_view text, char separator) {
  std::array<Number, count> out{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t end = text.find(separator);
    const auto number = number_in<Number>(text.substr(0, end));
    if (!number || (end == std::string_view::npos) != (i + 1 == count)) return {};
    out[i] = *number;
    if (i + 1 < count) text.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace hariko

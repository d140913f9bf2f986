#pragma once

// Words of enumerations: one table for each, for files, the command line, scripts and panels alike. The
// compiler checks that a table has the order of the enumerators and misses none.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/assert.hpp"

namespace hariko {

using Words = std::span<const std::string_view>;

/// Words of an enumeration in the order of its enumerators; each enumeration with words specialises it by
/// `all_words` or `first_words`.
template <class Enum>
inline constexpr auto enum_words = nullptr;

/// Enumerator with its word.
template <class Enum>
struct EnumWord {
  Enum value;
  std::string_view word;
};

namespace detail {

/// Whether a value has an enumerator, by the compiler's own spelling of it: a cast, "(Enum)7", where there is
/// none.
template <auto value>
constexpr bool is_enumerator() {
  const std::string_view name = __PRETTY_FUNCTION__;
  return name[name.rfind("= ") + 2] != '(';
}

}  // namespace detail

/// Table for an enumeration whose last enumerators have no word.
template <class Enum, std::size_t N>
constexpr std::array<std::string_view, N> first_words(const EnumWord<Enum> (&entries)[N]) {
  std::array<std::string_view, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    HARIKO_ASSERT(static_cast<std::size_t>(entries[i].value) == i, "words have the order of the enumerators");
    for (std::size_t k = 0; k < i; ++k)
      HARIKO_ASSERT(out[k] != entries[i].word, "each enumerator has its own word");
    out[i] = entries[i].word;
  }
  return out;
}

/// Table for an enumeration each of whose enumerators has a word.
template <class Enum, std::size_t N>
constexpr std::array<std::string_view, N> all_words(const EnumWord<Enum> (&entries)[N]) {
  static_assert(detail::is_enumerator<static_cast<Enum>(N - 1)>(), "the enumerators are counted from 0");
  static_assert(!detail::is_enumerator<static_cast<Enum>(N)>(), "an enumerator has no word");
  return first_words<Enum>(entries);
}

/// Word of an enumerator (asserted to have one).
template <class Enum>
std::string_view enum_word(Enum value) {
  const auto index = static_cast<std::size_t>(value);
  HARIKO_ASSERT(index < enum_words<Enum>.size(), "the enumerator has no word");
  return enum_words<Enum>[index];
}

/// Enumerators that have words, in their order.
template <class Enum>
constexpr auto enum_values() {
  std::array<Enum, enum_words<Enum>.size()> out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<Enum>(i);
  return out;
}

/// Words of an enumeration, for lists to choose from.
template <class Enum>
std::vector<std::string> enum_word_list() {
  return {enum_words<Enum>.begin(), enum_words<Enum>.end()};
}

/// Enumerator with a word; nothing where none has it.
template <class Enum>
std::optional<Enum> enum_value(std::string_view word) {
  const auto found = std::find(enum_words<Enum>.begin(), enum_words<Enum>.end(), word);
  if (found == enum_words<Enum>.end()) return std::nullopt;
  return static_cast<Enum>(found - enum_words<Enum>.begin());
}

}  // namespace hariko

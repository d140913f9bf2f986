#pragma once

// A labelled combo box over a fixed list of choices.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "core/base/text/enum_words.hpp"
#include "ui/widgets/panels.hpp"

namespace hariko {

/// Both in English; translated where they are shown.
struct Choice {
  const char* label;
  const char* help;
};

/// Labels of an enumeration in the order of its enumerators; `enum_labels.hpp` specialises it.
template <class Enum>
inline constexpr auto enum_choices = nullptr;

template <class Enum>
struct EnumChoice {
  Enum value;
  const char *label, *help;
};

/// Table for an enumeration each of whose enumerators that have a word has a label.
template <class Enum, std::size_t N>
constexpr std::array<Choice, N> all_choices(const EnumChoice<Enum> (&entries)[N]) {
  std::array<Choice, N> out{};
  for (std::size_t i = 0; i < N; ++i) {
    HARIKO_ASSERT(static_cast<std::size_t>(entries[i].value) == i,
                  "labels have the order of the enumerators");
    out[i] = {entries[i].label, entries[i].help};
  }
  if constexpr (!std::is_same_v<decltype(enum_words<Enum>), const std::nullptr_t>)
    static_assert(N == enum_words<Enum>.size(), "an enumerator with a word has no label");
  else
    static_assert(!detail::is_enumerator<static_cast<Enum>(N)>(), "an enumerator has no label");
  return out;
}

/// Label and help of an enumerator, in English.
template <class Enum>
constexpr const Choice& enum_choice(Enum value) {
  const auto index = static_cast<std::size_t>(value);
  HARIKO_ASSERT(index < enum_choices<Enum>.size(), "the enumerator has no label");
  return enum_choices<Enum>[index];
}

/// Returns the new choice. `current` < 0 shows "mixed". Marks: "combo.<id>" and "choice.<id>.<number>".
std::optional<int> choose(PanelContext& context, const char* id, const char* label, const char* help,
                          std::span<const Choice> choices, int current);

/// A small button that shows the present choice and opens a menu of all. Returns the new choice. Marks:
/// "<mark>" and "<mark>.<number>".
std::optional<int> choice_menu(PanelContext& context, const std::string& mark,
                               std::span<const Choice> choices, int current);

/// `choose` among all enumerators; nothing for `current` shows "mixed".
template <class Enum>
std::optional<Enum> choose(PanelContext& context, const char* id, const char* label, const char* help,
                           std::optional<Enum> current) {
  const auto chosen = choose(context, id, label, help, std::span<const Choice>(enum_choices<Enum>),
                             current ? static_cast<int>(*current) : -1);
  return chosen ? std::optional(static_cast<Enum>(*chosen)) : std::nullopt;
}

}  // namespace hariko

#pragma once

// Phrases: sentences and labels for users, in English until they are shown.

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hariko {

/// The number of a placeholder, "{0}" to "{9}", that stands at i; nothing when there is none.
std::optional<std::size_t> placeholder_at(std::string_view text, std::size_t i);

/// Replaces "{0}", "{1}" ... by the arguments; what has no argument stays. Translations may change the order.
std::string fill(std::string_view pattern, std::span<const std::string> arguments);
std::string fill(std::string_view pattern, std::initializer_list<std::string> arguments);

/// English text with what stands in its places, which is translated where it is shown: by its pattern, so
/// that names in it stay what they are.
class Phrase {
 public:
  Phrase() = default;
  Phrase(const char* text) : english_(text) {}             // NOLINT: implicit on purpose
  Phrase(std::string text) : english_(std::move(text)) {}  // NOLINT: implicit on purpose
  Phrase(std::string pattern, std::vector<std::string> arguments)
      : pattern_(std::move(pattern)),
        arguments_(std::move(arguments)),
        english_(fill(pattern_, arguments_)) {}
  /// A count, which fills {0}, in one of the two English forms: "Delete edge" and "Delete {0} edges".
  static Phrase counted(std::size_t count, const char* one, const char* many) {
    return {count == 1 ? one : many, {std::to_string(count)}};
  }

  /// With the places filled.
  const std::string& english() const { return english_; }
  bool empty() const { return english_.empty(); }
  /// Empty where nothing is filled in.
  const std::string& pattern() const { return pattern_; }
  const std::vector<std::string>& arguments() const { return arguments_; }
  /// Whether both say the same in English.
  friend bool operator==(const Phrase& a, const Phrase& b) { return a.english_ == b.english_; }

 private:
  std::string pattern_;
  std::vector<std::string> arguments_;
  std::string english_;
};

}  // namespace hariko

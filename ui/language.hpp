#pragma once

// Language: what the interface says. Strings are written in English in the code; a catalogue gives their
// translations.

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/base/message.hpp"
#include "core/base/result.hpp"

namespace hariko {

inline constexpr Code e_catalogue{"E_CATALOGUE"};

enum class LanguageId { english, japanese };

/// Marks a string that is translated later, where it is shown: a table of labels, for instance. A test looks
/// for the entries of everything marked so.
constexpr const char* translatable(const char* english) {
  return english;
}

/// Replaces "{0}", "{1}" ... by the arguments; what has no argument stays. Translations may change the order.
std::string fill(std::string_view pattern, std::initializer_list<std::string> arguments);

class Language {
 public:
  /// English: gives every string back.
  Language() = default;
  /// Reads a catalogue: a JSON object from English strings, and from codes of messages ("E_LOCKED"), to
  /// translations. Errors: E_CATALOGUE.
  static Result<Language> load(const std::filesystem::path& path);

  /// The translation, or the English string itself where there is none. The pointer lives as long as both do.
  const char* operator()(const char* english) const;
  std::string operator()(const std::string& english) const;
  bool has(std::string_view english) const;

  /// A message of the core: the translation of its code with the element it names, else its own sentence.
  std::string text_of(const Message& message) const;
  std::string remedy_of(const Message& message) const;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  std::unordered_map<std::string, std::string, Hash, std::equal_to<>> translations_;
};

}  // namespace hariko

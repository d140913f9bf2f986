#pragma once

// Language: what the interface says. Strings are written in English in the code; a catalogue gives their
// translations.

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"

namespace hariko {

inline constexpr Code e_catalogue{"E_CATALOGUE"};

enum class LanguageId { english, japanese };
template <>
inline constexpr auto enum_words<LanguageId> = all_words<LanguageId>({{LanguageId::english, "english"},
                                                                      {LanguageId::japanese, "japanese"}});

/// Marks a string that is translated later, where it is shown: a table of labels, for instance. A test looks
/// for the entries of everything marked so.
constexpr const char* translatable(const char* english) {
  return english;
}

/// Names of languages are shown in their own script.
inline constexpr const char* japanese_in_japanese = "\u65e5\u672c\u8a9e";
/// Why Japanese cannot be chosen.
inline constexpr const char* no_japanese_font =
    translatable("The font Noto Sans CJK is not installed (Debian package fonts-noto-cjk).");

/// The code points of UTF-8; what is no UTF-8 becomes U+FFFD.
std::u32string code_points(std::string_view utf8);

/// Replaces "{0}", "{1}" ... by the arguments; what has no argument stays. Translations may change the order.
std::string fill(std::string_view pattern, std::span<const std::string> arguments);
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

  /// For sentences that were filled before they came here (step labels, hints, reasons): the entry itself, or
  /// the entry with placeholders that it was made from, "Move {0} vertices" for "Move 3 vertices", filled
  /// again. What stands in the places stays as it is. The sentence itself where there is none. O(entries with
  /// placeholders).
  std::string phrase(std::string_view english) const;

  /// Every character that the translations need, ascending.
  std::u32string characters() const;

  /// A message of the core: the translation of its sentence, also behind what it is about ("a.ply": Line 3:
  /// ), else that of its code with the element it names, else its own sentence.
  std::string text_of(const Message& message) const;
  std::string remedy_of(const Message& message) const;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>{}(text); }
  };
  /// An entry with placeholders, cut at them: literals[0] {numbers[0]} literals[1] ...
  struct Pattern {
    std::vector<std::string> literals;
    std::vector<std::size_t> numbers;
    std::string translation;
  };
  static Pattern cut(const std::string& english, const std::string& translation);
  /// What stands in the places; nothing when the sentence is another one.
  static std::optional<std::vector<std::string>> match(const Pattern& pattern, std::string_view text);
  enum class Entries {
    all,
    sentences  ///< that end with a full stop, question mark or exclamation mark
  };
  std::optional<std::string> find_phrase(std::string_view english, Entries entries = Entries::all) const;
  std::optional<std::string> find_sentence(std::string_view english) const;
  /// "Line 3" by the entry "Line {0}"; everything else stays.
  std::string numbered(const std::string& english) const;

  std::unordered_map<std::string, std::string, Hash, std::equal_to<>> translations_;
  std::vector<Pattern> patterns_;  ///< those with most literal text first
};

}  // namespace hariko

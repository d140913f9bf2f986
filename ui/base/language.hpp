#pragma once

// Language: what the interface says. Strings are written in English in the code; a catalogue (.po) gives
// their translations.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/message.hpp"
#include "core/base/result.hpp"
#include "core/base/text/enum_words.hpp"
#include "core/base/text/phrase.hpp"
#include "core/base/text/plural_forms.hpp"
#include "core/base/text/po_file.hpp"

namespace hariko {

/// Marks a string that is translated later, where it is shown: a table of labels, for instance. A test looks
/// for the entries of everything marked so. Where one English text has two meanings, a word for the meaning
/// and the character U+0004 stand before it, "continuity\4Tangent": the msgctxt of its entry.
constexpr const char* translatable(const char* english) {
  return english;
}

/// Name of an enumerator by the names of all of them, in their order; the compiler misses that of a new one.
template <class Enum, std::size_t N>
constexpr const char* name_among(Enum value, const char* const (&names)[N]) {
  static_assert(!detail::is_enumerator<static_cast<Enum>(N)>(), "an enumerator has no name");
  return names[static_cast<std::size_t>(value)];
}

/// Reason why a language of Eastern Asia cannot be chosen.
inline constexpr const char* no_japanese_font =
    translatable("The font Noto Sans CJK is not installed (Debian package fonts-noto-cjk).");

/// The code points of UTF-8; what is no UTF-8 becomes U+FFFD.
std::u32string code_points(std::string_view utf8);

class Language {
 public:
  /// English: gives every string back.
  Language() = default;
  /// Reads a catalogue, whose texts are English strings and codes of messages ("E_LOCKED"). What it does not
  /// translate stays English. Errors: E_CATALOGUE, E_PLURAL_FORMS.
  static Result<Language> load(const std::filesystem::path& path);

  /// The translation, or the English string itself, without its context, where there is none. The pointer
  /// lives as long as both do.
  const char* operator()(const char* english) const;
  std::string operator()(const std::string& english) const;
  bool has(std::string_view english) const;

  /// A text with a count, which fills {0}: the form that the count takes, or one of the two English ones,
  /// "1 point" and "{0} points".
  std::string counted(std::size_t count, const char* one, const char* many) const;

  /// The translation of a phrase, in the form that its count takes; what stands in its places stays as it is.
  /// A text without places that has no entry is taken as by `phrase`.
  std::string operator()(const Phrase& text) const;

  /// For sentences that were filled before they came here (step labels, hints, reasons): the entry itself, or
  /// the entry with placeholders that it was made from, "Move {0} vertices" for "Move 3 vertices", filled
  /// again, in the form that its count takes. What stands in the places stays as it is. The sentence itself
  /// where there is none. O(entries with placeholders).
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
  template <class Value>
  using Texts = std::unordered_map<std::string, Value, Hash, std::equal_to<>>;
  using Forms = std::vector<std::string>;  ///< one for all counts, or one for each form
  /// An entry with placeholders, cut at them: literals[0] {numbers[0]} literals[1] ...
  struct Pattern {
    std::string english;  ///< uncut
    std::vector<std::string> literals;
    std::vector<std::size_t> numbers;
    Forms translations;
    std::size_t counted = 0;  ///< the argument whose count chooses the form
  };
  void add(PoEntry entry);
  void add_pattern(const std::string& english, const Forms& translations, std::size_t place);
  static Pattern cut(const std::string& english);
  /// Texts that stand in the places; nothing when the sentence is another one.
  static std::optional<std::vector<std::string>> match(const Pattern& pattern, std::string_view text);
  const std::string& form_for(const Pattern& pattern, const std::vector<std::string>& arguments) const;
  enum class Entries {
    all,
    sentences  ///< entries that end with a full stop, question mark or exclamation mark
  };
  std::optional<std::string> find_phrase(std::string_view english, Entries entries = Entries::all) const;
  std::optional<std::string> find_sentence(std::string_view english) const;
  /// "Line 3" by the entry "Line {0}"; everything else stays.
  std::string numbered(const std::string& english) const;

  PluralForms forms_;
  Texts<std::string> translations_;
  Texts<Forms> plurals_;           ///< by their text for one
  std::vector<Pattern> patterns_;  ///< those with most literal text first
  Texts<std::size_t> pattern_of_;  ///< by their English text
};

}  // namespace hariko

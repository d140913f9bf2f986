#pragma once

// KeyChord: a key with modifiers, and its text.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hariko {

/// A key with modifiers. Keys are GLFW key codes; letters, digits and signs are their ASCII codes (of upper
/// case).
struct KeyChord {
  int key = 0;
  bool control = false, shift = false, alt = false;

  /// From "Ctrl+Shift+Z", "Home", "Num 1", "?"; nothing for anything else.
  static std::optional<KeyChord> parse(std::string_view text);
  /// Text that `parse` reads. The key must be one that `is_known`.
  std::string to_string() const;
  /// Whether the key has a name: modifiers alone and keys for media have none.
  bool is_known() const;
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// From several chords separated by " / ", or none; nothing when one of them is no chord.
std::optional<std::vector<KeyChord>> parse_keys(std::string_view text);
std::string print_keys(std::span<const KeyChord> keys);

/// Every chord that has a text, for tests and for checking completeness.
std::vector<KeyChord> all_chords();

/// A letter for each menu, in capitals: the first of its English name that no earlier menu has; 0 where none
/// is left.
std::vector<char> menu_letters(const std::vector<std::string>& menus);

/// The menu that a key means, by its letter; null for none.
const std::string* menu_of_letter(const std::vector<std::string>& menus, int key);

}  // namespace hariko

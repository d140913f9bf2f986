#pragma once

// Key: a key of the keyboard. KeyChord: a key with modifiers, and its text.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hariko {

/// Keys of the keyboard. Letters, digits and signs have the ASCII code of what the layout prints on them,
/// letters that of the capital: `Key{'+'}` needs no name. The codes of the others are those of GLFW, by which
/// replays name them; `app/window/gl_window.cpp` checks it.
// clang-format off
enum class Key : int {
  none = 0,
  space = ' ', slash = '/', left_bracket = '[', right_bracket = ']',
  a = 'A', b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  escape = 256, enter, tab, backspace, insert, delete_forward,
  right, left, down, up, page_up, page_down, home, end,
  pause = 284,
  f1 = 290, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12, f25 = 314,
  keypad_0 = 320, keypad_1, keypad_2, keypad_3, keypad_4, keypad_5, keypad_6, keypad_7, keypad_8, keypad_9,
  keypad_decimal, keypad_divide, keypad_multiply, keypad_subtract, keypad_add, keypad_enter,
  menu = 348,
};
// clang-format on

/// Key by its place in the alphabet or among the function keys, counted from another one.
constexpr Key operator+(Key key, int places) {
  return static_cast<Key>(static_cast<int>(key) + places);
}
/// Places from one key to another.
constexpr int operator-(Key a, Key b) {
  return static_cast<int>(a) - static_cast<int>(b);
}

/// A key with modifiers.
struct KeyChord {
  Key key = Key::none;
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
const std::string* menu_of_letter(const std::vector<std::string>& menus, Key key);

}  // namespace hariko

#include "ui/base/key_chord.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace hariko {

namespace {

struct KeyName {
  Key key;
  std::string_view name;
};
constexpr std::array key_names{
    KeyName{Key::escape, "Esc"},
    KeyName{Key::delete_forward, "Del"},
    KeyName{Key::insert, "Ins"},
    KeyName{Key::home, "Home"},
    KeyName{Key::end, "End"},
    KeyName{Key::page_up, "PgUp"},
    KeyName{Key::page_down, "PgDn"},
    KeyName{Key::enter, "Enter"},
    KeyName{Key::space, "Space"},
    KeyName{Key::tab, "Tab"},
    KeyName{Key::backspace, "Backspace"},
    KeyName{Key::left, "Left"},
    KeyName{Key::right, "Right"},
    KeyName{Key::up, "Up"},
    KeyName{Key::down, "Down"},
    KeyName{Key::menu, "Menu"},
    KeyName{Key::pause, "Pause"},
    KeyName{Key::keypad_0, "Num 0"},
    KeyName{Key::keypad_1, "Num 1"},
    KeyName{Key::keypad_2, "Num 2"},
    KeyName{Key::keypad_3, "Num 3"},
    KeyName{Key::keypad_4, "Num 4"},
    KeyName{Key::keypad_5, "Num 5"},
    KeyName{Key::keypad_6, "Num 6"},
    KeyName{Key::keypad_7, "Num 7"},
    KeyName{Key::keypad_8, "Num 8"},
    KeyName{Key::keypad_9, "Num 9"},
    KeyName{Key::keypad_add, "Num +"},
    KeyName{Key::keypad_subtract, "Num -"},
    KeyName{Key::keypad_multiply, "Num *"},
    KeyName{Key::keypad_divide, "Num Slash"},
    KeyName{Key::keypad_decimal, "Num ."},
};
constexpr std::string_view signs = ",.;'/\\[]-=`";
constexpr int function_keys = Key::f25 - Key::f1 + 1;

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Letters, digits and signs, which are named by themselves.
bool is_plain(Key key) {
  const int code = static_cast<int>(key);
  return (code >= 'A' && code <= 'Z') || (code >= '0' && code <= '9') ||
         (code > 0 && code < 128 && signs.find(static_cast<char>(code)) != std::string_view::npos);
}

bool is_function_key(Key key) {
  return key >= Key::f1 && key <= Key::f25;
}

/// "F12"; `none` for anything else.
Key function_key(std::string_view text) {
  for (int i = 0; i < function_keys; ++i)
    if (text == "F" + std::to_string(i + 1)) return Key::f1 + i;
  return Key::none;
}

}  // namespace

std::optional<KeyChord> KeyChord::parse(std::string_view text) {
  KeyChord chord;
  for (bool more = true; more;) {
    more = false;
    if (take_prefix(text, "Ctrl+")) chord.control = more = true;
    if (take_prefix(text, "Shift+")) chord.shift = more = true;
    if (take_prefix(text, "Alt+")) chord.alt = more = true;
  }
  if (text == "?" && !chord.shift) {
    chord.shift = true;
    chord.key = Key::slash;
    return chord;
  }
  if (text.size() == 1 && is_plain(Key{static_cast<unsigned char>(text[0])})) {
    chord.key = Key{static_cast<unsigned char>(text[0])};
    return chord;
  }
  if (const Key key = function_key(text); key != Key::none) {
    chord.key = key;
    return chord;
  }
  const auto it = std::ranges::find_if(key_names, [&](const KeyName& e) { return e.name == text; });
  if (it == key_names.end()) return {};
  chord.key = it->key;
  return chord;
}

std::string KeyChord::to_string() const {
  std::string text;
  if (control) text += "Ctrl+";
  if (shift && key != Key::slash) text += "Shift+";
  if (alt) text += "Alt+";
  if (shift && key == Key::slash) return text + "?";
  if (is_plain(key)) return text + static_cast<char>(key);
  if (is_function_key(key)) return text + "F" + std::to_string(key - Key::f1 + 1);
  for (const KeyName& entry : key_names)
    if (entry.key == key) return text.append(entry.name);
  return text;
}

bool KeyChord::is_known() const {
  return is_plain(key) || is_function_key(key) ||
         std::ranges::any_of(key_names, [this](const KeyName& e) { return e.key == key; });
}

std::optional<std::vector<KeyChord>> parse_keys(std::string_view text) {
  std::vector<KeyChord> keys;
  for (bool more = !text.empty(); more;) {
    const std::size_t end = text.find(" / ");
    const auto chord = KeyChord::parse(text.substr(0, end));
    if (!chord) return {};
    keys.push_back(*chord);
    more = end != std::string_view::npos;
    if (more) text.remove_prefix(end + 3);
  }
  return keys;
}

std::string print_keys(std::span<const KeyChord> keys) {
  std::string text;
  for (const KeyChord& chord : keys) text += (text.empty() ? "" : " / ") + chord.to_string();
  return text;
}

std::vector<KeyChord> all_chords() {
  std::vector<KeyChord> out;
  for (int code = 0; code <= static_cast<int>(Key::menu); ++code)
    for (int modifiers = 0; modifiers < 8; ++modifiers) {
      const KeyChord chord{Key{code}, (modifiers & 1) != 0, (modifiers & 2) != 0, (modifiers & 4) != 0};
      if (chord.is_known()) out.push_back(chord);
    }
  return out;
}

std::vector<char> menu_letters(const std::vector<std::string>& menus) {
  std::vector<char> letters;
  for (const std::string& menu : menus) {
    char own = 0;
    for (const char c : menu) {
      const auto letter = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      if (letter < 'A' || letter > 'Z' || std::find(letters.begin(), letters.end(), letter) != letters.end())
        continue;
      own = letter;
      break;
    }
    letters.push_back(own);
  }
  return letters;
}

const std::string* menu_of_letter(const std::vector<std::string>& menus, Key key) {
  const std::vector<char> letters = menu_letters(menus);
  const auto found = std::find(letters.begin(), letters.end(), static_cast<char>(key));
  if (key < Key::a || key > Key::z || found == letters.end()) return nullptr;
  return &menus[static_cast<std::size_t>(found - letters.begin())];
}

}  // namespace hariko

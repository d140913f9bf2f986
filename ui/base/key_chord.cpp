#include "ui/base/key_chord.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace hariko {

namespace {

struct KeyName {
  int key;
  std::string_view name;
};
constexpr std::array key_names{
    KeyName{GLFW_KEY_ESCAPE, "Esc"},
    KeyName{GLFW_KEY_DELETE, "Del"},
    KeyName{GLFW_KEY_INSERT, "Ins"},
    KeyName{GLFW_KEY_HOME, "Home"},
    KeyName{GLFW_KEY_END, "End"},
    KeyName{GLFW_KEY_PAGE_UP, "PgUp"},
    KeyName{GLFW_KEY_PAGE_DOWN, "PgDn"},
    KeyName{GLFW_KEY_ENTER, "Enter"},
    KeyName{GLFW_KEY_SPACE, "Space"},
    KeyName{GLFW_KEY_TAB, "Tab"},
    KeyName{GLFW_KEY_BACKSPACE, "Backspace"},
    KeyName{GLFW_KEY_LEFT, "Left"},
    KeyName{GLFW_KEY_RIGHT, "Right"},
    KeyName{GLFW_KEY_UP, "Up"},
    KeyName{GLFW_KEY_DOWN, "Down"},
    KeyName{GLFW_KEY_MENU, "Menu"},
    KeyName{GLFW_KEY_PAUSE, "Pause"},
    KeyName{GLFW_KEY_KP_0, "Num 0"},
    KeyName{GLFW_KEY_KP_1, "Num 1"},
    KeyName{GLFW_KEY_KP_2, "Num 2"},
    KeyName{GLFW_KEY_KP_3, "Num 3"},
    KeyName{GLFW_KEY_KP_4, "Num 4"},
    KeyName{GLFW_KEY_KP_5, "Num 5"},
    KeyName{GLFW_KEY_KP_6, "Num 6"},
    KeyName{GLFW_KEY_KP_7, "Num 7"},
    KeyName{GLFW_KEY_KP_8, "Num 8"},
    KeyName{GLFW_KEY_KP_9, "Num 9"},
    KeyName{GLFW_KEY_KP_ADD, "Num +"},
    KeyName{GLFW_KEY_KP_SUBTRACT, "Num -"},
    KeyName{GLFW_KEY_KP_MULTIPLY, "Num *"},
    KeyName{GLFW_KEY_KP_DIVIDE, "Num Slash"},
    KeyName{GLFW_KEY_KP_DECIMAL, "Num ."},
};
constexpr std::string_view signs = ",.;'/\\[]-=`";
constexpr int function_keys = 25;

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Letters, digits and signs, which are named by themselves.
bool is_plain(int key) {
  return (key >= 'A' && key <= 'Z') || (key >= '0' && key <= '9') ||
         (key > 0 && key < 128 && signs.find(static_cast<char>(key)) != std::string_view::npos);
}

/// "F12"; 0 for anything else.
int function_key(std::string_view text) {
  for (int i = 1; i <= function_keys; ++i)
    if (text == "F" + std::to_string(i)) return GLFW_KEY_F1 + i - 1;
  return 0;
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
    chord.key = GLFW_KEY_SLASH;
    return chord;
  }
  if (text.size() == 1 && is_plain(static_cast<unsigned char>(text[0]))) {
    chord.key = static_cast<unsigned char>(text[0]);
    return chord;
  }
  if (const int key = function_key(text)) {
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
  if (shift && key != GLFW_KEY_SLASH) text += "Shift+";
  if (alt) text += "Alt+";
  if (shift && key == GLFW_KEY_SLASH) return text + "?";
  if (is_plain(key)) return text + static_cast<char>(key);
  if (key >= GLFW_KEY_F1 && key < GLFW_KEY_F1 + function_keys)
    return text + "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  for (const KeyName& entry : key_names)
    if (entry.key == key) return text.append(entry.name);
  return text;
}

bool KeyChord::is_known() const {
  return is_plain(key) || (key >= GLFW_KEY_F1 && key < GLFW_KEY_F1 + function_keys) ||
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
  for (int key = 0; key <= GLFW_KEY_LAST; ++key)
    for (int modifiers = 0; modifiers < 8; ++modifiers) {
      const KeyChord chord{key, (modifiers & 1) != 0, (modifiers & 2) != 0, (modifiers & 4) != 0};
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

const std::string* menu_of_letter(const std::vector<std::string>& menus, int key) {
  const std::vector<char> letters = menu_letters(menus);
  const auto found = std::find(letters.begin(), letters.end(), static_cast<char>(key));
  if (key < 'A' || key > 'Z' || found == letters.end()) return nullptr;
  return &menus[static_cast<std::size_t>(found - letters.begin())];
}

}  // namespace hariko

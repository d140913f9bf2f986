#include "ui/command_table.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

struct KeyName {
  int key;
  std::string_view name;
};
constexpr std::array key_names{
    KeyName{GLFW_KEY_ESCAPE, "Esc"},  KeyName{GLFW_KEY_DELETE, "Del"},
    KeyName{GLFW_KEY_HOME, "Home"},   KeyName{GLFW_KEY_END, "End"},
    KeyName{GLFW_KEY_ENTER, "Enter"}, KeyName{GLFW_KEY_SPACE, "Space"},
    KeyName{GLFW_KEY_TAB, "Tab"},     KeyName{GLFW_KEY_BACKSPACE, "Backspace"},
    KeyName{GLFW_KEY_F1, "F1"},       KeyName{GLFW_KEY_F3, "F3"},
    KeyName{GLFW_KEY_F11, "F11"},     KeyName{GLFW_KEY_KP_0, "Num 0"},
    KeyName{GLFW_KEY_KP_1, "Num 1"},  KeyName{GLFW_KEY_KP_3, "Num 3"},
    KeyName{GLFW_KEY_KP_5, "Num 5"},  KeyName{GLFW_KEY_KP_7, "Num 7"},
    KeyName{GLFW_KEY_COMMA, ","},     KeyName{GLFW_KEY_PERIOD, "."},
};

bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
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
  if (text.size() == 1 && ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= '0' && text[0] <= '9'))) {
    chord.key = static_cast<unsigned char>(text[0]);
    return chord;
  }
  for (const KeyName& entry : key_names)
    if (entry.name == text) {
      chord.key = entry.key;
      return chord;
    }
  return {};
}

std::string KeyChord::to_string() const {
  std::string text;
  if (control) text += "Ctrl+";
  if (shift) text += "Shift+";
  if (alt) text += "Alt+";
  for (const KeyName& entry : key_names)
    if (entry.key == key) return text.append(entry.name);
  return text + static_cast<char>(key);
}

void CommandTable::add(Command command) {
  HARIKO_ASSERT(!find(command.id), "command id already taken");
  HARIKO_ASSERT(command.run != nullptr, "a command must do something");
  std::string_view keys = command.keys;
  while (!keys.empty()) {
    const std::size_t end = keys.find(" / ");
    const auto chord = KeyChord::parse(keys.substr(0, end));
    HARIKO_ASSERT(chord.has_value(), "unknown key name");
    HARIKO_ASSERT(!find(*chord), "key already taken");
    chords_.emplace_back(*chord, commands_.size());
    keys = end == std::string_view::npos ? std::string_view() : keys.substr(end + 3);
  }
  commands_.push_back(std::move(command));
}

const Command* CommandTable::find(std::string_view id) const {
  const auto it =
      std::find_if(commands_.begin(), commands_.end(), [id](const Command& c) { return c.id == id; });
  return it == commands_.end() ? nullptr : &*it;
}

const Command* CommandTable::find(const KeyChord& chord) const {
  for (const auto& [known, index] : chords_)
    if (known == chord) return &commands_[index];
  return nullptr;
}

std::vector<std::string> CommandTable::menus() const {
  std::vector<std::string> menus;
  for (const Command& command : commands_)
    if (!command.menu.empty() && std::find(menus.begin(), menus.end(), command.menu) == menus.end())
      menus.push_back(command.menu);
  return menus;
}

CommandTable::Outcome CommandTable::run(std::string_view id) const {
  const Command* command = find(id);
  HARIKO_ASSERT(command != nullptr, "unknown command");
  return run(*command);
}

CommandTable::Outcome CommandTable::run(const Command& command) const {
  if (command.why_not)
    if (auto reason = command.why_not()) return {false, std::move(*reason)};
  if (before_run_) before_run_(command);
  command.run();
  return {true, {}};
}

}  // namespace hariko

#pragma once

// The command table: everything the program can be told to do, by name. Menus, shortcuts, buttons and tests
// read it.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hariko {

/// A key with modifiers. Keys are GLFW key codes; letters and digits are their ASCII codes.
struct KeyChord {
  int key = 0;
  bool control = false, shift = false, alt = false;

  /// From "Ctrl+Shift+Z", "Home", "Num 1"; nothing for anything else.
  static std::optional<KeyChord> parse(std::string_view text);
  std::string to_string() const;
  friend bool operator==(const KeyChord&, const KeyChord&) = default;
};

/// A key going down, and the character it types (0 for none): layouts differ in where digits and signs are.
struct KeyPress {
  KeyChord chord;
  char32_t text = 0;
};

struct Command {
  std::string id;     ///< "file.open": stable, for tests and key files
  std::string menu;   ///< the menu it stands in: "File"; empty for none
  std::string label;  ///< "Open…"
  std::string help;   ///< one sentence
  std::string keys;   ///< default keys, several separated by " / "
  const char* icon = "";
  bool changes_document = false;
  bool separator_before = false;
  std::function<void()> run;
  /// Why the command cannot run now, as a sentence; nothing when it can.
  std::function<std::optional<std::string>()> why_not = {};
  /// For switches: whether it is on.
  std::function<bool()> checked = {};
};

class CommandTable {
 public:
  /// Ids must be new, keys well-formed and not yet taken (asserted).
  void add(Command command);

  const std::vector<Command>& all() const { return commands_; }
  const Command* find(std::string_view id) const;
  const Command* find(const KeyChord& chord) const;
  /// Menus in the order in which they first appear.
  std::vector<std::string> menus() const;

  struct Outcome {
    bool ran = false;
    std::string reason;  ///< why not
  };
  /// Is called before any command runs, from wherever it was chosen.
  void before_run(std::function<void(const Command&)> hook) { before_run_ = std::move(hook); }
  /// Runs a command, or says why not. The id must exist.
  Outcome run(std::string_view id) const;
  Outcome run(const Command& command) const;

 private:
  std::vector<Command> commands_;
  std::vector<std::pair<KeyChord, std::size_t>> chords_;
  std::function<void(const Command&)> before_run_;
};

}  // namespace hariko

#pragma once

// The command table: everything the program can be told to do, by name. Menus, context menus, the palette,
// the cheat sheet, key bindings and tests read it.

#include <functional>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ui/base/key_chord.hpp"
#include "ui/editor/command_arguments.hpp"

namespace hariko {

/// Things under the pointer when a context menu opens; a set for commands, which may stand in several.
enum class Context : unsigned { none = 0, vertex = 1, edge = 2, face = 4, object = 8, empty = 16 };
constexpr Context operator|(Context a, Context b) {
  return static_cast<Context>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool overlap(Context a, Context b) {
  return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0;
}
inline constexpr Context any_element = Context::vertex | Context::edge | Context::face;

/// A key going down, and the character it types (0 for none): layouts differ in where digits and signs are.
struct KeyPress {
  KeyChord chord;
  char32_t text = 0;
};

/// Use of a command in a script, where that differs from the window.
struct ScriptUse {
  std::vector<ArgumentSpec> arguments = {};
  /// Runs in the place of `Command::run`. What it refuses is told by a notice of the editor.
  std::function<void(const Arguments&)> run = {};
  /// Surfaces are made first: `why_not` or `run` looks at them.
  bool looks_at_surfaces = false;
  /// Arguments that give the chosen objects a property as this one has it; nothing where it has no such
  /// property. For recording.
  std::function<std::vector<WrittenArgument>(const Object&)> read = {};
};

/// Reason why something cannot be done now, as a sentence; nothing where it can.
using Reason = std::optional<std::string>;
using WhyNot = std::function<Reason()>;

/// A row of the table. Rows name the members that differ from these values.
struct Command {
  std::string id = {};  ///< "file.open": stable, for tests and key files
  /// Menu and submenus: "File", or "View/Standard views"; empty for no menu.
  std::string menu = {};
  std::string label = {};  ///< "Open…"
  std::string help = {};   ///< one sentence
  std::string keys = {};   ///< several separated by " / "; the default when added, then those in use
  const char* icon = "";
  bool changes_document = false;
  bool separator_before = false;
  bool while_tool_runs = false;  ///< whether its keys work in the middle of a drag or a modal tool
  bool needs_window = false;     ///< `run` works with the pointer, a dialog or the window itself
  std::function<void()> run = {};
  WhyNot why_not = {};
  /// For switches: whether it is on.
  std::function<bool()> checked = {};
  Context contexts = Context::none;  ///< the context menus it stands in
  std::string default_keys = {};     ///< filled in by the table
  /// Whether it stands in a menu; otherwise `menu` tells the palette where what it is about stands.
  bool in_menu = true;
  ScriptUse script = {};
  /// Other names that designers know it by, for the palette: "fillet, chamfer", translated as a whole.
  std::string other_names = {};

  bool scriptable() const { return !needs_window || script.run; }
};

/// Reason of a command that is not `scriptable` in a script.
inline constexpr const char* needs_the_window = "This command needs the window.";

/// An entry of a key file that could not be used as it stands.
struct KeyProblem {
  enum class Kind { unknown_command, not_a_key, reserved, taken };
  Kind kind = Kind::unknown_command;
  std::string id, keys;  ///< the entry
  std::string other;     ///< for `taken`: the command that has the key
};

class CommandTable {
 public:
  /// Ids must be new, keys well-formed and not yet taken (asserted).
  void add(Command command);

  const std::vector<Command>& all() const { return commands_; }
  const Command* find(std::string_view id) const;
  const Command* find(const KeyChord& chord) const;
  /// Puts commands into the context menus of elements. The ids must exist (asserted).
  void show_in(Context contexts, std::initializer_list<std::string_view> ids);
  /// Gives a command other names for the palette. The id must exist, and have none yet (asserted).
  void call_also(std::string_view id, std::string names);
  /// Says how scripts use a command. The id must exist, and have no use yet (asserted).
  void use_in_scripts(std::string_view id, ScriptUse use);
  /// Top menus in the order of the bar: File, Edit ... Help; menus that it does not know stand before Help.
  std::vector<std::string> menus() const;

  /// Default keys, but for the commands that `overrides` (id → keys) names. An override takes its keys from
  /// commands that have them by default; of two overrides with the same key the first has it.
  std::vector<KeyProblem> rebind(const std::map<std::string, std::string>& overrides);
  /// `overrides` with other keys for one command. Keys that another command has now are taken from it. An
  /// entry that equals the default goes away.
  std::map<std::string, std::string> with_keys(std::map<std::string, std::string> overrides,
                                               std::string_view id, std::span<const KeyChord> keys) const;
  /// Esc cancels, always: it cannot be bound.
  static bool is_reserved(const KeyChord& chord);

  struct Outcome {
    bool ran = false;
    std::string reason;  ///< reason why not
  };
  /// Is called before any command runs, from wherever it was chosen.
  void before_run(std::function<void(const Command&)> hook) { before_run_ = std::move(hook); }
  /// Is called after a command ran or was refused.
  void after_run(std::function<void(const Command&, const Outcome&)> hook) { after_run_ = std::move(hook); }
  /// Runs a command, or says why not. The id must exist.
  Outcome run(std::string_view id) const;
  Outcome run(const Command& command) const;
  /// Runs a command as a script does, with arguments that `read_arguments` gave; or says why not.
  Outcome run_in_script(const Command& command, const Arguments& arguments) const;

 private:
  Command& existing(std::string_view id);
  Outcome run_by(const Command& command, const std::function<void()>& run) const;
  void use_keys(std::size_t command, const std::vector<KeyChord>& keys);

  std::vector<Command> commands_;
  std::vector<std::pair<KeyChord, std::size_t>> chords_;
  std::function<void(const Command&)> before_run_;
  std::function<void(const Command&, const Outcome&)> after_run_;
};

/// The row of a switch, which turns `on` round and is checked while it is on. `on` must outlive the table.
Command switching(Command row, bool& on);

/// Adds rows that stand in one menu. The members that nearly all rows have are arguments; `more` names
/// others.
class MenuRows {
 public:
  /// `while_tool_runs`: the keys of all rows work in the middle of a tool.
  MenuRows(CommandTable& table, std::string menu, bool while_tool_runs = false)
      : table_(table), menu_(std::move(menu)), while_tool_runs_(while_tool_runs) {}
  /// The next row stands below a line.
  void next_group() { separator_ = true; }
  void add(Command row);
  void add(std::string id, std::string label, std::string help, std::function<void()> run,
           WhyNot why_not = {}, Command more = {});
  /// Adds a row that changes the document.
  void add_edit(std::string id, std::string label, std::string help, std::function<void()> run,
                WhyNot why_not = {}, Command more = {});
  /// Adds the row of a switch.
  void add_switch(std::string id, std::string label, std::string help, bool& on, Command more = {});

 private:
  CommandTable& table_;
  std::string menu_;
  bool while_tool_runs_;
  bool separator_ = false;
};

/// An entry of a menu: a command, or a submenu with entries of its own.
struct MenuNode {
  const Command* command = nullptr;
  std::string submenu;  ///< its name in English when there is no command
  bool separator_before = false;
  std::vector<MenuNode> children;
};

/// The entries of a top menu. A submenu stands where its first command does.
std::vector<MenuNode> menu_tree(const CommandTable& table, std::string_view menu);

/// The entries of the context menu of an element: commands by menus, separated; submenus stay.
std::vector<MenuNode> context_menu_tree(const CommandTable& table, Context context);

/// The folders of a menu path: "View/Standard views" gives two.
std::vector<std::string> menu_folders(std::string_view menu);

}  // namespace hariko

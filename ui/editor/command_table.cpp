#include "ui/editor/command_table.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

/// Menus stand like this whatever the order in which their commands were added; others come before Help.
constexpr std::array<std::string_view, 14> menu_order{"File", "Edit",    "Select", "Add",  "Transform",
                                                      "Mesh", "Shape",   "Solids", "Skin", "Outline",
                                                      "View", "Analyse", "Paper",  "Help"};

std::size_t place_of(std::string_view menu) {
  const auto* it = std::find(menu_order.begin(), menu_order.end(), menu);
  return it == menu_order.end() ? 2 * menu_order.size() - 3
                                : 2 * static_cast<std::size_t>(it - menu_order.begin());
}

}  // namespace

void CommandTable::add(Command command) {
  HARIKO_ASSERT(!find(command.id), "command id already taken");
  HARIKO_ASSERT(command.run != nullptr, "a command must do something");
  const auto keys = parse_keys(command.keys);
  HARIKO_ASSERT(keys.has_value(), "unknown key name");
  for (const KeyChord& chord : *keys) {
    HARIKO_ASSERT(!find(chord) && !is_reserved(chord), "key already taken");
    chords_.emplace_back(chord, commands_.size());
  }
  command.keys = command.default_keys = print_keys(*keys);
  commands_.push_back(std::move(command));
}

const Command* CommandTable::find(std::string_view id) const {
  const auto it = std::ranges::find_if(commands_, [id](const Command& c) { return c.id == id; });
  return it == commands_.end() ? nullptr : &*it;
}

const Command* CommandTable::find(const KeyChord& chord) const {
  for (const auto& [known, index] : chords_)
    if (known == chord) return &commands_[index];
  return nullptr;
}

Command& CommandTable::existing(std::string_view id) {
  const auto it = std::ranges::find_if(commands_, [id](const Command& c) { return c.id == id; });
  HARIKO_ASSERT(it != commands_.end(), "unknown command");
  return *it;
}

void CommandTable::show_in(Context contexts, std::initializer_list<std::string_view> ids) {
  for (const std::string_view id : ids) {
    Command& command = existing(id);
    command.contexts = command.contexts | contexts;
  }
}

void CommandTable::call_also(std::string_view id, std::string names) {
  Command& command = existing(id);
  HARIKO_ASSERT(command.other_names.empty(), "the command has other names already");
  command.other_names = std::move(names);
}

void CommandTable::use_in_scripts(std::string_view id, ScriptUse use) {
  Command& command = existing(id);
  HARIKO_ASSERT(!command.script.run && command.script.arguments.empty(),
                "the command has a use in scripts already");
  HARIKO_ASSERT(use.run || use.arguments.empty(), "arguments need something that takes them");
  command.script = std::move(use);
}

std::vector<std::string> CommandTable::menus() const {
  std::vector<std::string> menus;
  for (const Command& command : commands_) {
    if (!command.in_menu) continue;
    const std::string menu = command.menu.substr(0, command.menu.find('/'));
    if (!menu.empty() && std::find(menus.begin(), menus.end(), menu) == menus.end()) menus.push_back(menu);
  }
  std::stable_sort(menus.begin(), menus.end(),
                   [](const std::string& a, const std::string& b) { return place_of(a) < place_of(b); });
  return menus;
}

bool CommandTable::is_reserved(const KeyChord& chord) {
  return chord.key == Key::escape;
}

void CommandTable::use_keys(std::size_t command, const std::vector<KeyChord>& keys) {
  commands_[command].keys = print_keys(keys);
  for (const KeyChord& chord : keys) chords_.emplace_back(chord, command);
}

std::vector<KeyProblem> CommandTable::rebind(const std::map<std::string, std::string>& overrides) {
  std::vector<KeyProblem> problems;
  std::map<std::string_view, std::vector<KeyChord>> replaced;
  chords_.clear();
  for (const auto& [id, text] : overrides) {
    const Command* command = find(id);
    const auto keys = parse_keys(text);
    if (!command || !keys) {
      problems.push_back(
          {command ? KeyProblem::Kind::not_a_key : KeyProblem::Kind::unknown_command, id, text, {}});
      continue;
    }
    std::vector<KeyChord> free;
    for (const KeyChord& chord : *keys) {
      const Command* owner = find(chord);
      const bool twice = std::find(free.begin(), free.end(), chord) != free.end();
      if (is_reserved(chord))
        problems.push_back({KeyProblem::Kind::reserved, id, chord.to_string(), {}});
      else if (owner)
        problems.push_back({KeyProblem::Kind::taken, id, chord.to_string(), owner->id});
      else if (!twice)
        free.push_back(chord);
    }
    use_keys(static_cast<std::size_t>(command - commands_.data()), free);
    replaced.emplace(command->id, free);
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    if (replaced.contains(commands_[i].id)) continue;
    auto keys = *parse_keys(commands_[i].default_keys);
    std::erase_if(keys, [this](const KeyChord& chord) { return find(chord) != nullptr; });
    use_keys(i, keys);
  }
  return problems;
}

std::map<std::string, std::string> CommandTable::with_keys(std::map<std::string, std::string> overrides,
                                                           std::string_view id,
                                                           std::span<const KeyChord> keys) const {
  const auto put = [&](const Command& command, const std::string& text) {
    if (text == command.default_keys)
      overrides.erase(command.id);
    else
      overrides[command.id] = text;
  };
  for (const Command& other : commands_) {
    auto left = *parse_keys(other.keys);
    const auto taken = [&](const KeyChord& chord) {
      return std::find(keys.begin(), keys.end(), chord) != keys.end();
    };
    if (other.id != id && std::erase_if(left, taken) > 0) put(other, print_keys(left));
  }
  const Command* command = find(id);
  HARIKO_ASSERT(command != nullptr, "unknown command");
  put(*command, print_keys(keys));
  return overrides;
}

CommandTable::Outcome CommandTable::run(std::string_view id) const {
  const Command* command = find(id);
  HARIKO_ASSERT(command != nullptr, "unknown command");
  return run(*command);
}

CommandTable::Outcome CommandTable::run(const Command& command) const {
  return run_by(command, command.run);
}

CommandTable::Outcome CommandTable::run_in_script(const Command& command, const Arguments& arguments) const {
  if (!command.scriptable()) return {false, needs_the_window};
  if (!command.script.run) return run_by(command, command.run);
  return run_by(command, [&] { command.script.run(arguments); });
}

CommandTable::Outcome CommandTable::run_by(const Command& command, const std::function<void()>& run) const {
  Outcome outcome{true, {}};
  if (command.why_not)
    if (auto reason = command.why_not()) outcome = {false, std::move(*reason)};
  if (outcome.ran) {
    if (before_run_) before_run_(command);
    run();
  }
  if (after_run_) after_run_(command, outcome);
  return outcome;
}

Command switching(Command row, bool& on) {
  row.run = [&on] { on = !on; };
  row.checked = [&on] { return on; };
  row.script = {.arguments = {optional(on_off_argument("on", row.label, {}))},
                .run = [&on](const Arguments& given) { on = given.has("on") ? given.on("on") : !on; }};
  return row;
}

void MenuRows::add(Command row) {
  row.menu = menu_;
  row.while_tool_runs = row.while_tool_runs || while_tool_runs_;
  if (std::exchange(separator_, false)) row.separator_before = true;
  table_.add(std::move(row));
}

void MenuRows::add(std::string id, std::string label, std::string help, std::function<void()> run,
                   WhyNot why_not, Command more) {
  more.id = std::move(id);
  more.label = std::move(label);
  more.help = std::move(help);
  more.run = std::move(run);
  more.why_not = std::move(why_not);
  add(std::move(more));
}

void MenuRows::add_edit(std::string id, std::string label, std::string help, std::function<void()> run,
                        WhyNot why_not, Command more) {
  more.changes_document = true;
  add(std::move(id), std::move(label), std::move(help), std::move(run), std::move(why_not), std::move(more));
}

void MenuRows::add_switch(std::string id, std::string label, std::string help, bool& on, Command more) {
  more.id = std::move(id);
  more.label = std::move(label);
  more.help = std::move(help);
  add(switching(std::move(more), on));
}

namespace {

/// Order of menus in a context menu: what is done to a thing stands before what is done with it; others come
/// last, in the order of the bar.
constexpr std::array<std::string_view, 8> context_order{"Add",  "Mesh", "Shape",  "Transform",
                                                        "Edit", "File", "Select", "View"};
std::ptrdiff_t place_in_context(std::string_view menu) {
  return std::find(context_order.begin(), context_order.end(), menu) - context_order.begin();
}

/// Puts a command below the folders, which are made where they do not exist yet.
void place(std::vector<MenuNode>& nodes, std::span<const std::string> folders, const Command& command,
           bool separator) {
  if (folders.empty()) {
    nodes.push_back({&command, {}, separator, {}});
    return;
  }
  auto it =
      std::ranges::find_if(nodes, [&](const MenuNode& n) { return !n.command && n.submenu == folders[0]; });
  if (it == nodes.end()) {
    nodes.push_back({nullptr, folders[0], separator, {}});
    it = nodes.end() - 1;
    separator = false;  // it stands before the submenu
  }
  place(it->children, folders.subspan(1), command, separator);
}

/// A line round each single entry is no grouping: it goes with the group before.
void join_single_nodes(std::span<MenuNode> nodes) {
  for (std::size_t i = 1; i < nodes.size(); ++i)
    if (i + 1 == nodes.size() || nodes[i + 1].separator_before) nodes[i].separator_before = false;
}

}  // namespace

std::vector<std::string> menu_folders(std::string_view menu) {
  std::vector<std::string> folders;
  while (!menu.empty()) {
    const std::size_t end = menu.find('/');
    folders.emplace_back(menu.substr(0, end));
    menu = end == std::string_view::npos ? std::string_view() : menu.substr(end + 1);
  }
  return folders;
}

std::vector<MenuNode> menu_tree(const CommandTable& table, std::string_view menu) {
  std::vector<MenuNode> nodes;
  for (const Command& command : table.all()) {
    const auto folders = menu_folders(command.menu);
    if (folders.empty() || folders[0] != menu) continue;
    place(nodes, std::span(folders).subspan(1), command, command.separator_before && !nodes.empty());
  }
  return nodes;
}

std::vector<MenuNode> context_menu_tree(const CommandTable& table, Context context) {
  std::vector<std::string> menus = table.menus();
  std::stable_sort(menus.begin(), menus.end(), [](const std::string& a, const std::string& b) {
    return place_in_context(a) < place_in_context(b);
  });
  std::vector<MenuNode> nodes;
  for (const std::string& menu : menus) {
    const std::size_t begin = nodes.size();
    bool separator = !nodes.empty();
    for (const Command& command : table.all()) {
      const auto folders = menu_folders(command.menu);
      if (folders.empty() || folders[0] != menu) continue;
      // The groups of the menu are groups here, whichever of their commands are shown.
      separator = separator || (command.separator_before && !nodes.empty());
      if (!overlap(command.contexts, context)) continue;
      // Things to add are a list of their own, and go with other things.
      place(nodes, std::span(folders).subspan(menu == "Add" ? 0 : 1), command, separator);
      separator = false;
    }
    join_single_nodes(std::span(nodes).subspan(begin));
  }
  return nodes;
}

}  // namespace hariko

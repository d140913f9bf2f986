#include "app/commands/command_line/subcommand_lines.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/command_line/checks.hpp"
#include "app/commands/commands.hpp"

namespace hariko {

void WindowCommandLine::add_to(CLI::App& app) {
  const std::string group = "Window";
  const auto add = [&](CLI::Option* option) {
    all_.push_back(option);
    return option;
  };
  add(app.add_option("FILE", options_.files, "Documents, meshes or CAD files to open in the window"));
  add(app.add_option("--width", options_.width, "Of the window, in the screen's coordinates"))
      ->check(positive_number())
      ->group(group)
      ->capture_default_str();
  add(app.add_option("--height", options_.height, "Of the window"))
      ->check(positive_number())
      ->group(group)
      ->capture_default_str();
  add(app.add_option("--scale", options_.scale, "Of the interface instead of the monitor's, 0.5 to 4"))
      ->check(CLI::Range(0.5, 4.0))
      ->group(group);
  auto* record = add(app.add_option("--record", options_.record, "File to write what the user does to"));
  record->group(group);
  auto* replay = add(app.add_option(
      "--replay", options_.replay,
      "File to play; the exit code is 1 when the document is another one at the end than it was then"));
  replay->group(group)->excludes(record);
  add(app.add_flag("--skip-pauses", options_.skip_pauses,
                   "Plays a replay without the pauses in which nothing happened"))
      ->group(group)
      ->needs(replay);
  // Option for tests: the help omits options without a group.
  add(app.add_option("--test-log", options_.test_log,
                     "File to write what happens to, one JSON line an event"))
      ->group("");
}

void WindowCommandLine::check_nothing_said(const CLI::App& command) const {
  for (const CLI::Option* option : all_) {
    if (option->empty()) continue;
    const std::string what =
        option->get_positional() ? "'" + option->results().front() + "'" : option->get_name();
    throw CLI::ParseError(
        what + " is for the window and cannot stand before the command '" + command.get_name() + "'",
        exit_usage);
  }
}

}  // namespace hariko

// hariko: subcommands run without a window; files alone, or nothing, open it.

#include <signal.h>

#include <CLI/CLI.hpp>

#include "app/application.hpp"
#include "app/commands/run_command.hpp"
#include "app/crash_report.hpp"

int main(int argc, char** argv) {
#ifndef __SANITIZE_ADDRESS__  // whose own report says more
  hariko::report_crashes();
#endif
  // A file that gets too large for a limit is an error of its writing, not the end of the program.
  ::signal(SIGXFSZ, SIG_IGN);
  if (const auto exit_code = hariko::run_command(argc, argv)) return *exit_code;
  hariko::WindowOptions options;
  CLI::App arguments("A modeler for free-form shapes");
  arguments.add_option("FILE", options.files, "Files to open");
  arguments.add_option("--test-log", options.test_log,
                       "Write what happens to this file, one JSON line an event");
  arguments.add_option("--width", options.width, "Width of the window");
  arguments.add_option("--height", options.height, "Height of the window");
  arguments.add_option("--scale", options.scale, "Scale of the interface instead of the monitor's")
      ->check(CLI::Range(0.5, 4.0));
  arguments.add_option("--record", options.record, "Write what the user does to this file");
  arguments
      .add_option("--replay", options.replay,
                  "Play what was recorded; the exit code is 1 when the document is another one at the end")
      ->excludes(arguments.get_option("--record"));
  arguments
      .add_flag("--skip-pauses", options.skip_pauses,
                "Play a replay without the pauses in which nothing happened")
      ->needs(arguments.get_option("--replay"));
  try {
    arguments.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return arguments.exit(error) == 0 ? 0 : 2;
  }
  return hariko::run_window(options);
}

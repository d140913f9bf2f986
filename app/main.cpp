// hariko: commands run without a window; files alone, or nothing, open it.

#include <signal.h>

#include <variant>

#include "app/application.hpp"
#include "app/commands/command_line/run_command.hpp"
#include "app/crash_report.hpp"
#include "core/base/sanitizer.hpp"

int main(int argc, char** argv) {
#ifndef HARIKO_ADDRESS_SANITIZER  // whose own report says more
  hariko::report_crashes();
#endif
  // A file that gets too large for a limit is an error of its writing, not the end of the program.
  ::signal(SIGXFSZ, SIG_IGN);
  const auto asked = hariko::run_command(argc, argv);
  if (const int* exit_code = std::get_if<int>(&asked)) return *exit_code;
  return hariko::run_window(std::get<hariko::WindowOptions>(asked));
}

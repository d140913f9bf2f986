// hariko: commands run without a window; files alone, or nothing, open it.

#include <signal.h>

#include <variant>

#include "app/application.hpp"
#include "app/commands/command_line/run_command.hpp"
#include "app/crash_report.hpp"
#include "core/base/sanitizer.hpp"

#ifdef HARIKO_ADDRESS_SANITIZER
// The module that reads and writes CAD files has the core linked in once more, as it has to.
extern "C" const char* __asan_default_options() {
  return "detect_odr_violation=0";
}
#endif

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

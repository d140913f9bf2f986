// Entry point of hariko: commands run without a window; files alone, or nothing, open it.

#include <signal.h>

#include <variant>

#include "app/application.hpp"
#include "app/commands/command_line/run_command.hpp"
#include "app/crash_report.hpp"
#include "core/base/sanitizer.hpp"

#ifdef HARIKO_ADDRESS_SANITIZER
// The module that reads and writes CAD files necessarily links the core a second time.
extern "C" const char* __asan_default_options() {
  return "detect_odr_violation=0";
}
#endif

int main(int argc, char** argv) {
#ifndef HARIKO_ADDRESS_SANITIZER  // its own report is more detailed
  hariko::report_crashes();
#endif
  // A file above the size limit is an error of its writing instead of the end of the program.
  ::signal(SIGXFSZ, SIG_IGN);
  const auto asked = hariko::run_command(argc, argv);
  if (const int* exit_code = std::get_if<int>(&asked)) return *exit_code;
  return hariko::run_window(std::get<hariko::WindowOptions>(asked));
}

#include "app/commands/console.hpp"

#include <chrono>
#include <cstdio>

namespace hariko {

namespace {

double now_milliseconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

}  // namespace

void report(std::string_view file, const Message& message) {
  std::string line(file);
  if (!line.empty()) line += ": ";
  line += message.severity == Severity::error ? "error " : "warning ";
  line += to_string(message);
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

bool print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) == 0 && written) return true;
  report("", make_error(e_output, "The result could not be written to the standard output.",
                        "Check that the disk is not full and that the reading program still runs."));
  return false;
}

Stopwatch::Stopwatch() : last_(now_milliseconds()) {}

double Stopwatch::lap() {
  const double now = now_milliseconds(), passed = now - last_;
  last_ = now;
  return passed;
}

}  // namespace hariko

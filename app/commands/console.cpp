#include "app/commands/console.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "app/commands/commands.hpp"
#include "core/base/text/sanitized_utf8.hpp"
#include "core/polyhedron/message_summary.hpp"

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

void report(std::string_view file, std::span<const Message> messages) {
  for (const MessageSummary& summary : summarised(messages)) report(file, one_message(summary));
}

int failure(const std::filesystem::path& file, const Message& error) {
  report(file.string(), error);
  return exit_failed;
}

ProgressLine::ProgressLine(std::string what) : what_(std::move(what)) {
  if (::isatty(STDERR_FILENO) != 0) thread_ = std::thread([this] { show(); });
}

ProgressLine::ProgressLine(const std::filesystem::path& file, std::string_view doing)
    : ProgressLine(sanitized_utf8(file.filename().string(), 60) + ": " + std::string(doing)) {}

ProgressLine::~ProgressLine() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  ends_.notify_one();
  thread_.join();
}

/// Draws the line ten times a second; short work shows nothing.
void ProgressLine::show() {
  constexpr std::chrono::milliseconds beat{100};
  constexpr const char* clear_line = "\r\033[K";
  std::unique_lock lock(mutex_);
  bool shown = false;
  while (!ends_.wait_for(lock, beat, [this] { return ended_; })) {
    const double fraction = progress_.fraction();
    std::string line = clear_line + what_;
    if (fraction >= 0) line += " " + std::to_string(static_cast<int>(100 * fraction)) + " %";
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
    shown = true;
  }
  if (shown) std::fputs(clear_line, stderr);
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

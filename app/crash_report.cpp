#include "app/crash_report.hpp"

#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstring>
#include <ctime>
#include <system_error>

namespace hariko {

namespace {

constexpr std::size_t stack_size = 64 * 1024, most_calls = 64;

/// Data of the handler, prepared before anything is broken. Signal handlers have no user data, and there is
/// one set of them for the process.
struct Prepared {
  std::array<char, 4096> file{};  ///< zero-terminated; empty for none
  std::array<char, 4096> about{};
  std::atomic<bool> complete = false;
};

Prepared& prepared() {
  static Prepared values;
  return values;
}

void say(int descriptor, const char* text) {
  // A closed standard error or a full disk cannot be helped.
  [[maybe_unused]] const auto written = ::write(descriptor, text, std::strlen(text));
}

/// Writes the digits of a number below 10,000.
void say_number(int descriptor, unsigned number, unsigned digits) {
  std::array<char, 5> text{};
  for (unsigned i = digits; i-- > 0; number /= 10) text[i] = static_cast<char>('0' + number % 10);
  say(descriptor, text.data());
}

/// Writes the time, "2026-11-25 16:02:11 UTC", without calls that may take locks.
void say_time(int descriptor) {
  using namespace std::chrono;
  const sys_seconds now{seconds(std::time(nullptr))};
  const sys_days today = floor<days>(now);
  const year_month_day date(today);
  const hh_mm_ss clock(now - today);
  say_number(descriptor, static_cast<unsigned>(static_cast<int>(date.year())), 4);
  say(descriptor, "-");
  say_number(descriptor, static_cast<unsigned>(date.month()), 2);
  say(descriptor, "-");
  say_number(descriptor, static_cast<unsigned>(date.day()), 2);
  say(descriptor, " ");
  say_number(descriptor, static_cast<unsigned>(clock.hours().count()), 2);
  say(descriptor, ":");
  say_number(descriptor, static_cast<unsigned>(clock.minutes().count()), 2);
  say(descriptor, ":");
  say_number(descriptor, static_cast<unsigned>(clock.seconds().count()), 2);
  say(descriptor, " UTC\n");
}

void say_signal(int descriptor, int signal) {
  say(descriptor, "hariko crashed: ");
  const char* name = ::sigabbrev_np(signal);
  say(descriptor, name ? name : "unknown signal");
  say(descriptor, "\n");
}

/// Signal handler. Makes only calls that are safe while the heap is broken or locked.
void report(int signal) {
  std::array<void*, most_calls> calls{};
  const int count = ::backtrace(calls.data(), most_calls);
  say_signal(STDERR_FILENO, signal);
  ::backtrace_symbols_fd(calls.data(), count, STDERR_FILENO);
  const Prepared& ready = prepared();
  const int file = ready.complete && ready.file[0] != '\0'
                       ? ::open(ready.file.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)
                       : -1;
  if (file >= 0) {
    say_signal(file, signal);
    say_time(file);
    say(file, ready.about.data());
    ::backtrace_symbols_fd(calls.data(), count, file);
    ::close(file);
  }
  ::raise(signal);  // the handler is removed by now: the default action ends the program
}

/// Copies text with a terminating zero; text that is too long is truncated.
template <std::size_t N>
void put(std::array<char, N>& to, std::string_view text) {
  const std::size_t size = std::min(text.size(), N - 1);
  std::copy_n(text.data(), size, to.begin());
  to[size] = '\0';
}

}  // namespace

void report_crashes() {
  // Stack for the handler alone: the thread's own may have overflowed.
  static std::array<char, stack_size> stack;
  stack_t alternative{};
  alternative.ss_sp = stack.data();
  alternative.ss_size = stack.size();
  ::sigaltstack(&alternative, nullptr);
  std::array<void*, 1> first{};
  ::backtrace(first.data(), 1);  // loads the libraries that it needs while memory is available
  (void)prepared();
  struct sigaction action {};
  action.sa_handler = report;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
  ::sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) ::sigaction(signal, &action, nullptr);
}

void keep_crash_reports(const std::filesystem::path& file, std::string_view about) {
  std::error_code unknown;  // without a folder there is no file; the standard error has everything
  std::filesystem::create_directories(file.parent_path(), unknown);
  Prepared& values = prepared();
  values.complete = false;
  // A truncated path would name another file.
  put(values.file, file.native().size() < values.file.size() ? file.native() : std::string());
  put(values.about, std::string(about) + "\n");
  values.complete = true;
}

}  // namespace hariko

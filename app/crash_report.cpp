#include "app/crash_report.hpp"

#include <execinfo.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace hariko {

namespace {

constexpr std::size_t stack_size = 64 * 1024, most_calls = 64;

void say(const char* text) {
  // Nothing can be done about a standard error that is closed.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

/// Only calls that are safe while the heap is broken or locked.
void report(int signal) {
  say("hariko crashed: ");
  const char* name = ::sigabbrev_np(signal);
  say(name ? name : "unknown signal");
  say("\n");
  std::array<void*, most_calls> calls{};
  ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), most_calls), STDERR_FILENO);
  ::raise(signal);  // the handler is gone by now: the default ends the program
}

}  // namespace

void report_crashes() {
  static std::array<char, stack_size> stack;  // the handler's own: the thread's may be what overflowed
  stack_t alternative{};
  alternative.ss_sp = stack.data();
  alternative.ss_size = stack.size();
  ::sigaltstack(&alternative, nullptr);
  std::array<void*, 1> first{};
  ::backtrace(first.data(), 1);  // loads what it needs now, while memory can be had
  struct sigaction action {};
  action.sa_handler = report;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
  ::sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) ::sigaction(signal, &action, nullptr);
}

}  // namespace hariko

#include "app/window/signal_watch.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>

namespace hariko {

namespace {

sigset_t ending_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGTERM, SIGHUP, SIGINT}) {
    struct sigaction now {};
    if (::sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&set, signal);
  }
  return set;
}

/// Ends the process with a shell's exit code for a signal.
[[noreturn]] void end_process(int signal) {
  ::_exit(128 + signal);
}

}  // namespace

SignalWatch::SignalWatch() {
  // The end of the X server appears first as a write to a closed socket.
  ::signal(SIGPIPE, SIG_IGN);
  const sigset_t set = ending_signals();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signals_ = ::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
  stop_ = ::eventfd(0, EFD_CLOEXEC);
  if (signals_ < 0 || stop_ < 0) {  // no descriptors left: signals keep their default actions
    ::pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    return;
  }
  thread_ = std::thread([this] { watch(); });
}

SignalWatch::~SignalWatch() {
  if (thread_.joinable()) {
    const std::uint64_t one = 1;
    // An eventfd takes eight bytes at once; nothing needs to be repeated.
    if (::write(stop_, &one, sizeof one) == sizeof one)
      thread_.join();
    else
      thread_.detach();
  }
  if (signals_ >= 0) ::close(signals_);
  if (stop_ >= 0) ::close(stop_);
}

void SignalWatch::set_action(std::function<void(int)> action) {
  const std::lock_guard lock(mutex_);
  action_ = std::move(action);
}

void SignalWatch::watch() {
  int first = 0;
  std::array<pollfd, 2> sources{pollfd{signals_, POLLIN, 0}, pollfd{stop_, POLLIN, 0}};
  for (;;) {
    const int ready = ::poll(sources.data(), sources.size(), first != 0 ? patience * 1000 : -1);
    if (ready < 0 && errno == EINTR) continue;
    if (sources[1].revents != 0) return;
    if (first != 0) end_process(first);  // the time is over, or a second signal came
    signalfd_siginfo info{};
    if (::read(signals_, &info, sizeof info) != sizeof info) continue;
    first = static_cast<int>(info.ssi_signo);
    std::function<void(int)> action;
    {
      const std::lock_guard lock(mutex_);
      action = action_;
    }
    if (!action) end_process(first);
    action(first);
  }
}

}  // namespace hariko

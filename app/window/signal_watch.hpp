#pragma once

// SignalWatch: signals to end (SIGTERM, SIGHUP, SIGINT) as calls on a thread of its own, free of the
// restrictions of signal handlers.

#include <functional>
#include <mutex>
#include <thread>

namespace hariko {

/// Watches signals. To be created before any other thread, which then inherit that the signals are blocked.
/// Signals that were ignored when the program started (nohup) stay ignored.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Sets the function that is called with the number of the first signal. The process is ended `patience`
  /// seconds later, or at the next signal, unless it has ended by itself: its main thread may be stuck.
  /// Without a function it is ended immediately.
  void set_action(std::function<void(int signal)> action);
  static constexpr int patience = 5;

 private:
  void watch();

  std::mutex mutex_;
  std::function<void(int)> action_;
  int signals_ = -1, stop_ = -1;  ///< file descriptors
  std::thread thread_;
};

}  // namespace hariko

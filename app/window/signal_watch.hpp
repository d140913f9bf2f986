#pragma once

// SignalWatch: requests to end (SIGTERM, SIGHUP, SIGINT) as calls on a thread of its own, where everything is
// allowed that is not within a signal handler.

#include <functional>
#include <mutex>
#include <thread>

namespace hariko {

/// Make it before any other thread: those inherit that the signals are blocked. Signals that were ignored
/// when the program started (nohup) stay ignored.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  /// Calls `action` with the number of the first signal. The process ends `patience` seconds after that, or
  /// at the next signal, if it has not ended by itself: its main thread may be stuck. Without an action it
  /// ends at once.
  void set_action(std::function<void(int signal)> action);
  static constexpr int patience = 5;

 private:
  void watch();

  std::mutex mutex_;
  std::function<void(int)> action_;
  int signals_ = -1, stop_ = -1;  ///< descriptors
  std::thread thread_;
};

}  // namespace hariko

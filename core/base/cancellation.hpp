#pragma once

// Cancellation: a flag shared between the caller of a long computation and the computation.

#include <atomic>
#include <memory>

#include "core/base/message.hpp"

namespace hariko {

/// Error code of a computation that was cancelled.
inline constexpr Code e_cancelled{"E_CANCELLED"};

/// Handle of a shared cancellation flag; copies share it. A default token is never cancelled. Thread-safe.
class CancelToken {
 public:
  CancelToken() = default;
  /// A token with a flag of its own.
  static CancelToken make() {
    CancelToken token;
    token.flag_ = std::make_shared<std::atomic<bool>>(false);
    return token;
  }
  /// Requests cancellation of the computation; a default token ignores it.
  void cancel() const {
    if (flag_) flag_->store(true, std::memory_order_relaxed);
  }
  bool cancelled() const { return flag_ && flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

}  // namespace hariko

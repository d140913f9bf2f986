#pragma once

// Cancellation: one flag, shared between the one who may lose interest and the one who works.

#include <atomic>
#include <memory>

#include "core/base/message.hpp"

namespace hariko {

/// What work that was cancelled gives instead of its result.
inline constexpr Code e_cancelled{"E_CANCELLED"};

/// Copies share the flag. A default token is never cancelled. Thread-safe.
class CancelToken {
 public:
  CancelToken() = default;
  static CancelToken make() {
    CancelToken token;
    token.flag_ = std::make_shared<std::atomic<bool>>(false);
    return token;
  }
  void cancel() const {
    if (flag_) flag_->store(true, std::memory_order_relaxed);
  }
  bool cancelled() const { return flag_ && flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

}  // namespace hariko

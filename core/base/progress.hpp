#pragma once

// Progress: the finished fraction of a computation, shared between the computation and its display.

#include <algorithm>
#include <atomic>
#include <memory>

namespace hariko {

/// Handle of a shared fraction; copies share it. A default one reports to nobody. Thread-safe.
class Progress {
 public:
  Progress() = default;
  /// A progress with a fraction of its own, at first negative.
  static Progress make() {
    Progress progress;
    progress.fraction_ = std::make_shared<std::atomic<double>>(-1.0);
    return progress;
  }
  /// Progress of one part of the work: its 0 .. 1 is `begin` .. `end` of the whole.
  Progress part(double begin, double end) const {
    Progress progress = *this;
    progress.begin_ = begin_ + begin * length_;
    progress.length_ = (end - begin) * length_;
    return progress;
  }
  /// Reports that `fraction` of this part is done; clamped to [0, 1].
  void report(double fraction) const {
    if (fraction_)
      fraction_->store(begin_ + length_ * std::clamp(fraction, 0.0, 1.0), std::memory_order_relaxed);
  }
  /// Finished fraction of the whole, 0 .. 1; negative while nothing has been reported.
  double fraction() const { return fraction_ ? fraction_->load(std::memory_order_relaxed) : -1; }

 private:
  std::shared_ptr<std::atomic<double>> fraction_;
  double begin_ = 0, length_ = 1;
};

}  // namespace hariko

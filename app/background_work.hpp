#pragma once

// BackgroundWork: work on files off the main thread, named in the status line while it runs.

#include <memory>
#include <string>
#include <utility>

#include "app/work_lane.hpp"
#include "ui/editor.hpp"

namespace hariko {

/// Jobs run one after the other in the order in which they were given. For the main thread.
class BackgroundWork {
 public:
  BackgroundWork(Editor& editor, std::function<void()> wake) : editor_(editor), lane_(std::move(wake)) {}

  /// Runs `work(cancel)` on the worker; `done` gets its result on the main thread. `what` names it; empty for
  /// work that nobody has to know of.
  template <class Work, class Done>
  void run(std::string what, Work work, Done done) {
    const bool shown = !what.empty();
    if (shown) editor_.job = std::move(what);
    lane_.submit(
        next_++,
        [this, shown, work = std::move(work),
         done = std::move(done)](const CancelToken& cancel) -> WorkLane::Publication {
          auto result = std::make_shared<decltype(work(cancel))>(work(cancel));
          return [this, shown, result, done] {
            if (shown) editor_.job.clear();
            done(*result);
          };
        },
        WorkLane::Running::finish);
  }
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  void wait() { lane_.wait(); }

 private:
  Editor& editor_;
  WorkLane::Key next_ = 0;
  WorkLane lane_;  ///< last: its thread stops before the rest goes
};

}  // namespace hariko

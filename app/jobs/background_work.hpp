#pragma once

// BackgroundWork: work on files off the main thread, shown in the status line while it runs.

#include <memory>
#include <utility>

#include "app/engines/work_lane.hpp"
#include "ui/editor/editor.hpp"

namespace hariko {

/// Queue of jobs that run one after the other in the order of submission. For the main thread.
class BackgroundWork {
 public:
  BackgroundWork(Editor& editor, std::function<void()> wake) : editor_(editor), lane_(std::move(wake)) {}
  ~BackgroundWork() {
    for (const auto& job : shown_) job->cancel.cancel();
  }
  BackgroundWork(const BackgroundWork&) = delete;
  BackgroundWork& operator=(const BackgroundWork&) = delete;

  /// Runs `work(cancel)` on the worker and passes its result to `done` on the main thread. `what` names it in
  /// the status line; empty for work that is not shown.
  template <class Work, class Done>
  void run(Phrase what, Work work, Done done) {
    submit(what.empty() ? nullptr : show(std::move(what), false), std::move(work), std::move(done));
  }

  /// Runs `work(cancel, progress)`, which the user may cancel: it should then return soon, and `done` gets
  /// its result in that case, too.
  template <class Work, class Done>
  void run_cancellable(Phrase what, Work work, Done done, Job::Kind kind = Job::Kind::other) {
    const auto job = show(std::move(what), true, kind);
    submit(
        job, [job, work = std::move(work)](const CancelToken&) { return work(job->cancel, job->progress); },
        std::move(done));
  }

  /// Calls `done` for finished jobs; returns their number.
  std::size_t publish() { return lane_.publish(); }
  bool idle() const { return lane_.idle(); }
  /// Waits for all jobs, for tests and for shutting down.
  void wait() { lane_.wait(); }

 private:
  using SharedJob = std::shared_ptr<const Job>;

  SharedJob show(Phrase what, bool can_be_cancelled, Job::Kind kind = Job::Kind::other) {
    shown_.push_back(std::make_shared<const Job>(
        Job{std::move(what), can_be_cancelled, CancelToken::make(), Progress::make(), kind}));
    editor_.jobs.push_back(shown_.back());
    return shown_.back();
  }

  template <class Work, class Done>
  void submit(SharedJob job, Work work, Done done) {
    lane_.submit(
        next_++,
        [this, job = std::move(job), work = std::move(work),
         done = std::move(done)](const CancelToken& cancel) -> WorkLane::Publication {
          auto result = std::make_shared<decltype(work(cancel))>(work(cancel));
          return [this, job, result, done] {
            if (job) std::erase(shown_, job);
            if (job) std::erase(editor_.jobs, job);
            done(*result);
          };
        },
        WorkLane::Running::finish);
  }

  Editor& editor_;
  std::vector<SharedJob> shown_;
  WorkLane::Key next_ = 0;
  WorkLane lane_;  ///< last: its thread stops before the other members are destroyed
};

}  // namespace hariko

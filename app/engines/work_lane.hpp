#pragma once

// WorkLane: one worker thread that runs the latest job of each key, and hands results to the main thread.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/cancellation.hpp"

namespace hariko {

/// Jobs run one at a time, off the calling thread. Of each key at most one job runs and one waits: a newer
/// job replaces the waiting one. Waiting jobs of different keys run in the order in which their keys began to
/// wait.
///
/// A job returns what is to be done with its result; `publish` calls that on the main thread, in the order in
/// which jobs finished. A job that was cancelled is never published. All members but the jobs are for one
/// thread only (the main thread); jobs must not touch what the main thread may change.
class WorkLane {
 public:
  using Key = std::uint64_t;
  using Publication = std::function<void()>;
  /// Should return soon after the token is cancelled, with anything. May return an empty function.
  using Job = std::function<Publication(const CancelToken&)>;

  /// What a new job does to a running one of the same key: `finish` lets it end and be published first (a
  /// drag shows every surface that is ready, so a slow one cannot starve the screen); `cancel` makes it stop
  /// and drops its result.
  enum class Running { finish, cancel };

  /// `wake` is called from the worker whenever there is something to publish, or nothing left to do.
  explicit WorkLane(std::function<void()> wake = {});
  /// Cancels everything and waits for the running job to return.
  ~WorkLane();
  WorkLane(const WorkLane&) = delete;
  WorkLane& operator=(const WorkLane&) = delete;

  void submit(Key key, Job job, Running running);
  /// Drops the waiting job of a key, cancels the running one, and drops its finished, unpublished results.
  void cancel(Key key);
  /// Applies finished results. Returns how many.
  std::size_t publish();
  /// Whether a job of the key waits or runs, or its result is not published yet.
  bool busy(Key key) const;
  bool idle() const;
  /// Blocks until nothing waits or runs (results may still have to be published). For shutting down and for
  /// tests.
  void wait();

 private:
  struct Waiting {
    Key key;
    Job job;
    CancelToken token;
  };
  struct Finished {
    Key key;
    Publication publication;
  };
  void work();

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Waiting> waiting_;  ///< oldest first, keys differ
  std::optional<std::pair<Key, CancelToken>> running_;
  std::vector<Finished> finished_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace hariko

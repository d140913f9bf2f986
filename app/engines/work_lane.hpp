#pragma once

// WorkLane: a worker thread that runs the latest job of each key and passes results to the main thread.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/cancellation.hpp"

namespace hariko {

/// Job queue with one worker thread. For each key at most one job runs and one waits: a newer job replaces
/// the waiting one. Waiting jobs of different keys run in the order in which their keys began to wait.
///
/// A job returns a function that applies its result; `publish` calls these on the main thread, in the order
/// in which the jobs finished. Results of cancelled jobs are dropped. All members are for one thread only
/// (the main thread); jobs must not touch anything that the main thread may change.
class WorkLane {
 public:
  using Key = std::uint64_t;
  using Publication = std::function<void()>;
  /// Job: should return soon after the token is cancelled, with any value. May return an empty function.
  using Job = std::function<Publication(const CancelToken&)>;

  /// Effect of a new job on a running one of the same key: `finish` lets it end and be published first (a
  /// drag shows every surface that is ready, so a slow one cannot starve the screen); `cancel` stops it and
  /// drops its result.
  enum class Running { finish, cancel };

  /// `wake`: called from the worker whenever there is something to publish, or nothing left to do.
  explicit WorkLane(std::function<void()> wake = {});
  /// Cancels everything and waits for the running job to return.
  ~WorkLane();
  WorkLane(const WorkLane&) = delete;
  WorkLane& operator=(const WorkLane&) = delete;

  /// Submits a job.
  void submit(Key key, Job job, Running running);
  /// Drops the waiting job of a key, cancels the running one, and drops finished results that are not
  /// published.
  void cancel(Key key);
  /// Applies finished results; returns their number.
  std::size_t publish();
  /// Whether a job of the key waits or runs, or its result is not published yet.
  bool busy(Key key) const;
  bool idle() const;
  /// Blocks until no job waits or runs (results may remain unpublished). For shutting down and for tests.
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
  std::vector<Waiting> waiting_;  ///< oldest first, with distinct keys
  std::optional<std::pair<Key, CancelToken>> running_;
  std::vector<Finished> finished_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace hariko

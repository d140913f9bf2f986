#include "app/engines/work_lane.hpp"

#include <algorithm>

namespace hariko {

WorkLane::WorkLane(std::function<void()> wake) : wake_(std::move(wake)), thread_([this] { work(); }) {}

WorkLane::~WorkLane() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    waiting_.clear();
    if (running_) running_->second.cancel();
  }
  changed_.notify_all();
  thread_.join();
}

void WorkLane::submit(Key key, Job job, Running running) {
  {
    const std::lock_guard lock(mutex_);
    if (running == Running::cancel && running_ && running_->first == key) running_->second.cancel();
    if (running == Running::cancel)
      std::erase_if(finished_, [key](const Finished& result) { return result.key == key; });
    Waiting next{key, std::move(job), CancelToken::make()};
    const auto same =
        std::ranges::find_if(waiting_, [key](const Waiting& waiting) { return waiting.key == key; });
    if (same != waiting_.end())
      *same = std::move(next);
    else
      waiting_.push_back(std::move(next));
  }
  changed_.notify_all();
}

void WorkLane::cancel(Key key) {
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [key](const Waiting& waiting) { return waiting.key == key; });
  std::erase_if(finished_, [key](const Finished& result) { return result.key == key; });
  if (running_ && running_->first == key) running_->second.cancel();
}

std::size_t WorkLane::publish() {
  // One at a time and without the lock: a publication may submit or cancel jobs, also the next one here.
  std::size_t count = 0;
  std::unique_lock lock(mutex_);
  while (!finished_.empty()) {
    Finished result = std::move(finished_.front());
    finished_.erase(finished_.begin());
    lock.unlock();
    result.publication();
    ++count;
    lock.lock();
  }
  return count;
}

bool WorkLane::busy(Key key) const {
  const std::lock_guard lock(mutex_);
  return (running_ && running_->first == key) ||
         std::ranges::any_of(waiting_, [key](const auto& waiting) { return waiting.key == key; }) ||
         std::ranges::any_of(finished_, [key](const auto& result) { return result.key == key; });
}

bool WorkLane::idle() const {
  const std::lock_guard lock(mutex_);
  return !running_ && waiting_.empty() && finished_.empty();
}

void WorkLane::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !running_ && waiting_.empty(); });
}

void WorkLane::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (stopping_) return;
    Waiting next = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    running_ = {next.key, next.token};
    lock.unlock();
    Publication publication = next.job(next.token);
    next.job = {};  // destroys its captures without holding the lock
    lock.lock();
    running_.reset();
    const bool keep = publication && !next.token.cancelled();
    if (keep) finished_.push_back({next.key, std::move(publication)});
    changed_.notify_all();
    // Also after cancelled work, if no other follows: whoever waits for the idle state must learn of it.
    if ((keep || waiting_.empty()) && wake_) {
      lock.unlock();
      wake_();
      lock.lock();
    }
  }
}

}  // namespace hariko

#include "app/persistence/autosaver.hpp"

#include <algorithm>
#include <utility>

namespace hariko {

Autosaver::Autosaver(RecoveryStore store, std::shared_ptr<FileLayer> layer)
    : store_(std::move(store)), layer_(std::move(layer)) {}

void Autosaver::set_work(Work work) {
  const std::lock_guard lock(state_mutex_);
  work_ = std::move(work);
}

bool Autosaver::is_latest(const State& state) const {
  const std::lock_guard lock(state_mutex_);
  return work_ && work_->state == state;
}

void Autosaver::set_nothing() {
  const std::lock_guard lock(state_mutex_);
  work_.reset();
}

bool Autosaver::waits() const {
  return work_ ? written_ != work_->state : copy_exists_;
}

bool Autosaver::due(double now, double interval) const {
  return due_in(now, interval) == 0;
}

double Autosaver::due_in(double now, double interval) const {
  const std::lock_guard lock(state_mutex_);
  if (!waits()) return -1;
  if (!work_ && !failed_) return 0;  // a copy of saved or discarded work must not reappear
  return std::max(0.0, started_ + interval - now);
}

void Autosaver::started(double now) {
  const std::lock_guard lock(state_mutex_);
  started_ = now;
}

bool Autosaver::up_to_date() const {
  const std::lock_guard lock(state_mutex_);
  return !waits();
}

Result<Done> Autosaver::write(std::int64_t unix_seconds) {
  const std::lock_guard disk(disk_mutex_);
  std::optional<Work> work;
  {
    const std::lock_guard lock(state_mutex_);
    if (!waits()) return Done{};
    work = work_;
  }
  if (!work) {
    auto cleared = slot_ ? slot_->clear(*layer_) : Result<Done>(Done{});
    const std::lock_guard lock(state_mutex_);
    failed_ = !cleared.ok();
    if (cleared.ok()) {
      copy_exists_ = false;
      written_.reset();
    }
    return cleared;
  }
  if (!slot_) {
    auto created = store_.create(unix_seconds);
    if (!created) {
      const std::lock_guard lock(state_mutex_);
      failed_ = true;
      return created.error();
    }
    slot_ = std::move(created).value();
  }
  work->note.written_at = unix_seconds;
  auto written = slot_->write(work->document, work->note, *layer_);
  const std::lock_guard lock(state_mutex_);
  failed_ = !written.ok();
  copy_exists_ = true;  // also after a failure, as a part may have been written
  if (written.ok()) written_ = work->state;
  return written;
}

void Autosaver::adopt(RecoverySlot slot, Work work) {
  const std::lock_guard disk(disk_mutex_);
  if (slot_) (void)slot_->clear(*layer_);
  slot_ = std::move(slot);
  const std::lock_guard lock(state_mutex_);
  written_ = work.state;
  work_ = std::move(work);
  copy_exists_ = true;
}

}  // namespace hariko

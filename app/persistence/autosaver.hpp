#pragma once

// Autosaver: keeps the last committed document and decides when its recovery copy has to be written.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "app/persistence/recovery_store.hpp"

namespace hariko {

/// The main thread says what there is; any thread may write, so that a signal or a lost display can do so at
/// once while the main thread is stuck.
class Autosaver {
 public:
  /// Names a state of a document: `epoch` differs between documents, `serial` between states
  /// (History::serial).
  struct State {
    std::uint64_t epoch = 0, serial = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  struct Work {
    Document document;
    State state;
    RecoveryNote note;
  };

  Autosaver(RecoveryStore store, std::shared_ptr<FileLayer> layer = std::make_shared<SystemFileLayer>());

  /// Work that is nowhere on the disk. Cheap to call often with the same state: `is_latest` tells.
  void set_work(Work work);
  bool is_latest(const State& state) const;
  /// There is nothing to lose any more: the copy goes with the next `write`.
  void set_nothing();

  /// Whether `write` should be called: something changed, and `interval` seconds went by since it was called
  /// last. `now` is any steady clock in seconds. The first change after a rest is due at once.
  bool due(double now, double interval) const;
  /// Seconds until it may be due; negative when nothing waits to be written.
  double due_in(double now, double interval) const;
  /// Call where a write is started, with the same clock: the interval counts from there.
  void started(double now);

  /// Brings the disk up to date: writes the copy, or removes it when there is nothing to lose. Returns when
  /// it is done; after an error it is due again when the interval is over.
  Result<Done> write(std::int64_t unix_seconds);
  /// Whether the disk holds what was last said.
  bool up_to_date() const;

  /// Takes over the place of recovered work, whose copy is `state`; the own copy is removed.
  void adopt(RecoverySlot slot, Work work);

 private:
  bool waits() const;

  RecoveryStore store_;
  std::shared_ptr<FileLayer> layer_;

  mutable std::mutex state_mutex_;  ///< of these; never held while the disk is used
  std::optional<Work> work_;
  std::optional<State> written_;  ///< what the copy on disk is of
  bool copy_exists_ = false, failed_ = false;
  double started_ = -1e9;

  std::mutex disk_mutex_;  ///< of these; taken before state_mutex_
  std::optional<RecoverySlot> slot_;
};

}  // namespace hariko

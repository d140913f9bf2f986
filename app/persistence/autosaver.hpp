#pragma once

// Autosaver: holds the last committed document and decides when its recovery copy must be written.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "app/persistence/recovery_store.hpp"

namespace hariko {

/// Autosave of one document. The main thread sets the work; any thread may write, so that a signal or a lost
/// display can do so immediately while the main thread is stuck.
class Autosaver {
 public:
  /// Identifies a state of a document: `epoch` differs between documents, `serial` between states
  /// (History::serial), `saves` between the files that it was saved to, which its note names.
  struct State {
    std::uint64_t epoch = 0, serial = 0, saves = 0;
    friend bool operator==(const State&, const State&) = default;
  };
  struct Work {
    Document document;
    State state;
    RecoveryNote note;
  };

  Autosaver(RecoveryStore store, std::shared_ptr<FileLayer> layer = std::make_shared<SystemFileLayer>());

  /// Sets work that is not saved. `is_latest` tells cheaply whether a state is set already.
  void set_work(Work work);
  bool is_latest(const State& state) const;
  /// Declares that there is nothing to lose: the next `write` removes the copy.
  void set_nothing();

  /// Whether `write` should be called: something changed, and `interval` seconds have passed since the last
  /// call. `now` is any steady clock in seconds. The first change after a rest is due immediately.
  bool due(double now, double interval) const;
  /// Seconds until `write` may be due; negative where nothing waits to be written.
  double due_in(double now, double interval) const;
  /// Records the start of a write, by the same clock: the interval counts from there.
  void started(double now);

  /// Updates the disk: writes the copy, or removes it where there is nothing to lose. Returns when that is
  /// done; after an error it is due again after the interval.
  Result<Done> write(std::int64_t unix_seconds);
  /// Whether the disk has the last state that was set.
  bool up_to_date() const;

  /// Takes over the slot of recovered work, whose copy has the given state; removes the own copy.
  void adopt(RecoverySlot slot, Work work);

 private:
  bool waits() const;

  RecoveryStore store_;
  std::shared_ptr<FileLayer> layer_;

  mutable std::mutex state_mutex_;  ///< guards the members below; never held during disk access
  std::optional<Work> work_;
  std::optional<State> written_;  ///< state of the copy on disk
  bool copy_exists_ = false, failed_ = false;
  double started_ = -1e9;

  std::mutex disk_mutex_;  ///< guards the members below; taken before state_mutex_
  std::optional<RecoverySlot> slot_;
};

}  // namespace hariko

#pragma once

// RecoveryStore: recovery copies of all running and ended sessions, each in a folder of its own under a lock.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/persistence/file_lock.hpp"
#include "core/document/recovery.hpp"

namespace hariko {

inline constexpr Code e_recovery_taken{"E_RECOVERY_TAKEN"};    ///< another window is using it
inline constexpr Code e_recovery_folder{"E_RECOVERY_FOLDER"};  ///< the folder cannot be made or locked

/// The place of one document's recovery copy. Other processes leave it alone while it exists. For one thread
/// at a time.
class RecoverySlot {
 public:
  RecoverySlot(RecoverySlot&&) noexcept = default;
  RecoverySlot& operator=(RecoverySlot&&) noexcept;
  /// What was not cleared stays for the next start.
  ~RecoverySlot();

  Result<Done> write(const Document& document, const RecoveryNote& note, FileLayer& layer);
  Result<Done> clear(FileLayer& layer);
  const std::filesystem::path& folder() const { return folder_; }

 private:
  friend class RecoveryStore;
  RecoverySlot(std::filesystem::path folder, FileLock lock)
      : folder_(std::move(folder)), lock_(std::move(lock)) {}
  void leave();

  std::filesystem::path folder_;
  FileLock lock_;
};

/// What an ended session left behind.
struct Leftover {
  std::string id;
  RecoveryNote note;
  std::size_t objects = 0;
  std::filesystem::path copy;  ///< a document file, to make a picture of; empty when damaged
  bool file_changed = false;   ///< the original is no longer the file that the copy was made from
  bool damaged = false;
};

/// Any number of processes may use the same folder at once.
class RecoveryStore {
 public:
  /// The folder is made when it is needed.
  explicit RecoveryStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// A new, empty place for a copy. Errors: E_RECOVERY_FOLDER.
  Result<RecoverySlot> create(std::int64_t now) const;
  /// What ended sessions left, latest first. Reads the copies, and removes those whose document is what the
  /// original file holds: nothing of them is lost.
  std::vector<Leftover> leftovers(std::int64_t now) const;
  /// How many sessions may have left something: quick, as nothing is read.
  std::size_t candidates(std::int64_t now) const;
  /// Takes over a leftover: it stays on disk until it is cleared. Errors: E_RECOVERY_TAKEN,
  /// E_RECOVERY_FOLDER, E_NO_RECOVERY when it is gone.
  Result<RecoverySlot> adopt(const std::string& id, std::int64_t now) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace hariko

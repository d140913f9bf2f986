#pragma once

// RecoveryStore: recovery copies of all running and ended sessions, each in its own locked folder.

#include <filesystem>
#include <string>
#include <vector>

#include "app/persistence/file_lock.hpp"
#include "core/document/history/recovery.hpp"

namespace hariko {

inline constexpr Code e_recovery_taken{"E_RECOVERY_TAKEN"};    ///< used by another window
inline constexpr Code e_recovery_folder{"E_RECOVERY_FOLDER"};  ///< the folder cannot be created or locked

/// Place of one document's recovery copy. Other processes do not touch it during its life. For one thread at
/// a time.
class RecoverySlot {
 public:
  RecoverySlot(RecoverySlot&&) noexcept = default;
  RecoverySlot& operator=(RecoverySlot&&) noexcept;
  /// Releases the place; a copy that was not cleared stays for the next start.
  ~RecoverySlot();

  /// Writes the copy. Errors: those of writing files.
  Result<Done> write(const Document& document, const RecoveryNote& note, FileLayer& layer);
  /// Removes the copy.
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

/// Recovery copy of an ended session.
struct Leftover {
  std::string id;
  RecoveryNote note;
  std::size_t objects = 0;
  std::filesystem::path copy;  ///< document file, for a picture of it; empty where damaged
  bool file_changed = false;   ///< the original is no longer the file that the copy was made from
  bool damaged = false;
};

/// Folder of recovery copies; any number of processes may use it at once.
class RecoveryStore {
 public:
  /// The folder is created when it is needed.
  explicit RecoveryStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Creates an empty place for a copy. Errors: E_RECOVERY_FOLDER.
  Result<RecoverySlot> create(std::int64_t now) const;
  /// Copies of ended sessions, latest first. Reads them, and removes those whose document equals the original
  /// file.
  std::vector<Leftover> leftovers(std::int64_t now) const;
  /// Number of sessions that may have left a copy; fast, as nothing is read.
  std::size_t candidates(std::int64_t now) const;
  /// Takes over a copy, which stays on disk until it is cleared. Errors: E_RECOVERY_TAKEN, E_RECOVERY_FOLDER,
  /// E_NO_RECOVERY where it no longer exists.
  Result<RecoverySlot> adopt(const std::string& id, std::int64_t now) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace hariko

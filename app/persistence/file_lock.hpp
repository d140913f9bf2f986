#pragma once

// FileLock: a file whose existence and kernel lock tell that a process uses something.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace hariko {

/// Holder of a lock. A process is identified by its number, its start and the boot of its machine, as numbers
/// are reused.
struct LockOwner {
  std::string host, user;
  std::string boot;  ///< id of the machine's boot
  std::int64_t process = 0;
  std::uint64_t process_start = 0;  ///< clock ticks after the boot
  std::int64_t since = 0;           ///< seconds since 1970, UTC

  friend bool operator==(const LockOwner&, const LockOwner&) = default;
};

/// Identity of this process; `since` is 0.
LockOwner this_process();
/// Whether the process may still run; always true for other machines, of which nothing is known.
bool may_be_alive(const LockOwner& owner);

/// Advisory lock by the kernel (flock). It ends with the process in any case, so a file that is left behind
/// locks nothing. On file systems without locks the file itself decides, and whether its owner is alive.
class FileLock {
 public:
  struct Attempt;
  using FlockCall = std::function<int(int descriptor, int operation)>;

  /// Tries to lock `path`, whose folder must exist. Never waits.
  static Attempt try_lock(const std::filesystem::path& path, std::int64_t now);
  /// Same with another flock function, for tests.
  static Attempt try_lock(const std::filesystem::path& path, std::int64_t now, const FlockCall& flock);

  FileLock() = default;  ///< holds no lock
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  /// Removes the file and releases the lock.
  ~FileLock();

  bool held() const { return descriptor_ >= 0; }
  const std::filesystem::path& path() const { return path_; }

 private:
  FileLock(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  void release();

  int descriptor_ = -1;
  std::filesystem::path path_;
};

/// Result of an attempt to lock.
struct FileLock::Attempt {
  enum class Outcome {
    acquired,
    taken,        ///< held by another process, or by another lock of this one
    unavailable,  ///< the file cannot be created, for `reason`
  };
  Outcome outcome = Outcome::unavailable;
  FileLock lock;                   ///< held where acquired
  bool certain = true;             ///< false on file systems without locks
  std::optional<LockOwner> owner;  ///< owner where it is taken, as far as the file tells
  std::string reason;
};

/// Path of a document's lock: a hidden file beside it, so that other users and machines see it. Symbolic
/// links are resolved: two names of one file have one lock.
std::filesystem::path lock_path_of(const std::filesystem::path& document);

}  // namespace hariko

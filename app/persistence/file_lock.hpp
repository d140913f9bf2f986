#pragma once

// FileLock: a file whose existence and kernel lock say that a process is using something.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace hariko {

/// Who holds a lock. A process is known by its number, its start and the boot of its machine: numbers return.
struct LockOwner {
  std::string host, user;
  std::string boot;  ///< id of the machine's boot
  std::int64_t process = 0;
  std::uint64_t process_start = 0;  ///< clock ticks after the boot
  std::int64_t since = 0;           ///< seconds since 1970, UTC

  friend bool operator==(const LockOwner&, const LockOwner&) = default;
};

/// This process; `since` is 0.
LockOwner this_process();
/// Whether the process may still run. Of another machine nothing can be known: true.
bool may_be_alive(const LockOwner& owner);

/// The lock is the kernel's (flock): it ends with the process however that ends, so a file that is left
/// behind locks nothing. Where the file system knows no locks, the file itself and the life of its owner
/// decide.
class FileLock {
 public:
  struct Attempt;
  using FlockCall = std::function<int(int descriptor, int operation)>;

  /// Takes the lock at `path`, whose folder exists. Never waits.
  static Attempt try_lock(const std::filesystem::path& path, std::int64_t now);
  /// With another flock, for tests.
  static Attempt try_lock(const std::filesystem::path& path, std::int64_t now, const FlockCall& flock);

  FileLock() = default;  ///< holds nothing
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  /// Removes the file and gives the lock back.
  ~FileLock();

  bool held() const { return descriptor_ >= 0; }
  const std::filesystem::path& path() const { return path_; }

 private:
  FileLock(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}
  void release();

  int descriptor_ = -1;
  std::filesystem::path path_;
};

struct FileLock::Attempt {
  enum class Outcome {
    acquired,
    taken,        ///< another process (or another lock of this one) holds it
    unavailable,  ///< the file cannot be made; `reason` says why
  };
  Outcome outcome = Outcome::unavailable;
  FileLock lock;                   ///< held when acquired
  bool certain = true;             ///< false where the file system knows no locks
  std::optional<LockOwner> owner;  ///< when taken, where the file says so
  std::string reason;
};

/// Where the lock of a document lies: a hidden file beside it, so that other users and machines see it.
/// Symbolic links are followed: two names of one file have one lock.
std::filesystem::path lock_path_of(const std::filesystem::path& document);

}  // namespace hariko

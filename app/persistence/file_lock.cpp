#include "app/persistence/file_lock.hpp"

#include <fcntl.h>
#include <pwd.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/base/text/json_writer.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

using Json = nlohmann::json;
using Outcome = FileLock::Attempt::Outcome;

std::string first_line(const char* path) {
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  return line;
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? sanitized_utf8(name.data()) : std::string();
}

std::string user_name() {
  const passwd* entry = ::getpwuid(::getuid());
  return entry && entry->pw_name ? sanitized_utf8(entry->pw_name) : std::to_string(::getuid());
}

/// Start time of a process: field 22 of /proc/<process>/stat; 0 where there is no such process.
std::uint64_t start_of(std::int64_t process) {
  const std::string line = first_line(("/proc/" + std::to_string(process) + "/stat").c_str());
  const std::size_t name_end = line.rfind(')');  // a program's name may have spaces and brackets
  if (name_end == std::string::npos) return 0;
  std::istringstream fields(line.substr(name_end + 1));
  std::string skipped;
  for (int field = 3; field < 22; ++field) fields >> skipped;
  std::uint64_t start = 0;
  fields >> start;
  return start;
}

std::string text_of(const LockOwner& owner) {
  JsonWriter json;
  json.object([&] {
    json.member("host", owner.host);
    json.member("user", owner.user);
    json.member("boot", owner.boot);
    json.member("process", owner.process);
    json.member("process_start", owner.process_start);
    json.member("since", owner.since);
  });
  return json.take() + "\n";
}

std::optional<LockOwner> read_owner(int descriptor) {
  std::array<char, 4096> bytes{};
  const ssize_t size = ::pread(descriptor, bytes.data(), bytes.size(), 0);
  if (size <= 0) return {};
  const Json json = Json::parse(bytes.data(), bytes.data() + size, nullptr, false);
  if (!json.is_object()) return {};
  try {
    return LockOwner{json.at("host"),    json.at("user"),          json.at("boot"),
                     json.at("process"), json.at("process_start"), json.at("since")};
  } catch (const Json::exception&) {
    return {};
  }
}

bool write_owner(int descriptor, std::int64_t now) {
  LockOwner owner = this_process();
  owner.since = now;
  const std::string text = text_of(owner);
  return ::ftruncate(descriptor, 0) == 0 &&
         ::pwrite(descriptor, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

/// Whether the descriptor is still the file of that name: its last holder may have removed it meanwhile.
bool is_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat open_file {
  }, named{};
  return ::fstat(descriptor, &open_file) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open_file.st_dev == named.st_dev && open_file.st_ino == named.st_ino;
}

FileLock::Attempt unavailable(int error) {
  FileLock::Attempt attempt;
  attempt.reason = std::generic_category().message(error);
  return attempt;
}

FileLock::Attempt taken(int descriptor, bool certain) {
  FileLock::Attempt attempt;
  attempt.outcome = Outcome::taken;
  attempt.certain = certain;
  attempt.owner = read_owner(descriptor);
  return attempt;
}

}  // namespace

LockOwner this_process() {
  LockOwner owner;
  owner.host = host_name();
  owner.user = user_name();
  owner.boot = first_line("/proc/sys/kernel/random/boot_id");
  owner.process = ::getpid();
  owner.process_start = start_of(owner.process);
  return owner;
}

bool may_be_alive(const LockOwner& owner) {
  if (owner.host != host_name()) return true;
  if (owner.boot != first_line("/proc/sys/kernel/random/boot_id")) return false;
  return start_of(owner.process) == owner.process_start && owner.process_start != 0;
}

FileLock::Attempt FileLock::try_lock(const std::filesystem::path& path, std::int64_t now) {
  return try_lock(path, now, [](int descriptor, int operation) { return ::flock(descriptor, operation); });
}

FileLock::Attempt FileLock::try_lock(const std::filesystem::path& path, std::int64_t now,
                                     const FlockCall& flock) {
  constexpr int attempts = 100;  // each retry means that a holder has just released it
  for (int i = 0; i < attempts; ++i) {
    int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
    // A file of another user can be locked, though not written.
    if (descriptor < 0 && errno == EACCES)
      descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) return unavailable(errno);
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    const int error = errno;
    if (!locked && error == EINTR) {
      ::close(descriptor);
      continue;
    }
    if (!locked && error == EWOULDBLOCK) {
      Attempt attempt = taken(descriptor, true);
      ::close(descriptor);
      return attempt;
    }
    if (!locked) {  // a file system without locks: the owner decides by being alive
      Attempt attempt = taken(descriptor, false);
      if (attempt.owner && may_be_alive(*attempt.owner)) {
        ::close(descriptor);
        return attempt;
      }
    }
    if (!is_file_at(descriptor, path)) {
      ::close(descriptor);
      continue;
    }
    if (!write_owner(descriptor, now) && !locked) {
      const int failed = errno;
      ::close(descriptor);
      return unavailable(failed);
    }
    Attempt attempt;
    attempt.outcome = Outcome::acquired;
    attempt.certain = locked;
    attempt.lock = FileLock(descriptor, path);
    return attempt;
  }
  return unavailable(EAGAIN);
}

FileLock::FileLock(FileLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), path_(std::move(other.path_)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  if (this == &other) return *this;
  release();
  descriptor_ = std::exchange(other.descriptor_, -1);
  path_ = std::move(other.path_);
  return *this;
}

FileLock::~FileLock() {
  release();
}

void FileLock::release() {
  if (descriptor_ < 0) return;
  // The name is removed before the lock is released: who opens the name later finds another file or none.
  if (is_file_at(descriptor_, path_)) ::unlink(path_.c_str());
  ::close(descriptor_);
  descriptor_ = -1;
}

std::filesystem::path lock_path_of(const std::filesystem::path& document) {
  std::error_code error;
  std::filesystem::path real = std::filesystem::weakly_canonical(document, error);
  if (error) real = document;
  return real.parent_path() / ("." + real.filename().native() + ".lock");
}

}  // namespace hariko

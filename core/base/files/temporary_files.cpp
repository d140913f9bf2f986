#include "core/base/files/temporary_files.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <ctime>
#include <optional>
#include <string_view>
#include <system_error>

namespace hariko {

namespace {

constexpr std::string_view prefix = ".hariko-", suffix = ".tmp";

/// Process id in a name made by `temporary_name`; nothing for other names.
std::optional<pid_t> writer_of(std::string_view name) {
  if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() < prefix.size() + suffix.size())
    return {};
  name.remove_prefix(prefix.size());
  name.remove_suffix(suffix.size());
  pid_t process = 0;
  unsigned number = 0;
  const char* const end = name.data() + name.size();
  const auto first = std::from_chars(name.data(), end, process);
  if (first.ec != std::errc() || process <= 0 || first.ptr == end || *first.ptr != '-') return {};
  const auto second = std::from_chars(first.ptr + 1, end, number);
  if (second.ec != std::errc() || second.ptr != end) return {};
  return process;
}

bool lives(pid_t process) {
  return ::kill(process, 0) == 0 || errno == EPERM;
}

/// Whether a file is regular, old enough, and locked by nobody.
bool abandoned(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return false;
  struct stat status {};
  const bool old = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
                   status.st_mtime + stale_seconds < std::time(nullptr);
  // The file stays where the file system has no locks, as writers on other machines cannot be excluded.
  const bool free = old && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return free;
}

}  // namespace

std::string temporary_name(int number) {
  return std::string(prefix) + std::to_string(::getpid()) + "-" + std::to_string(number) +
         std::string(suffix);
}

std::size_t remove_stale_temporaries(const std::filesystem::path& folder) {
  std::size_t removed = 0;
  std::error_code error;
  std::filesystem::directory_iterator it(folder, error);
  for (; !error && it != std::filesystem::directory_iterator(); it.increment(error)) {
    const auto writer = writer_of(it->path().filename().native());
    if (!writer || lives(*writer) || !abandoned(it->path())) continue;
    std::error_code unknown;
    if (std::filesystem::remove(it->path(), unknown)) ++removed;
  }
  return removed;
}

}  // namespace hariko

#include "core/base/files/file_stamp.hpp"

#include <sys/stat.h>

namespace hariko {

std::optional<FileStamp> stamp_of(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return {};
  constexpr std::int64_t nanoseconds = 1'000'000'000;
  return FileStamp{static_cast<std::uint64_t>(status.st_size),
                   status.st_mtim.tv_sec * nanoseconds + status.st_mtim.tv_nsec, status.st_dev,
                   status.st_ino};
}

}  // namespace hariko

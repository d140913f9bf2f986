#pragma once

// FileStamp: identifies the state of a file on disk, to detect changes by other programs.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace hariko {

/// Fingerprint of a file on disk. Any program that writes the file changes at least one of these.
struct FileStamp {
  std::uint64_t size = 0;     ///< bytes
  std::int64_t modified = 0;  ///< nanoseconds since 1970, UTC
  std::uint64_t device = 0, inode = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Stamp of a file, or nothing when there is no such file. Follows symbolic links.
std::optional<FileStamp> stamp_of(const std::filesystem::path& path);

}  // namespace hariko

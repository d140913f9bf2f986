#pragma once

// RecentFiles: what was opened or saved last, kept in a file that all windows share.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

struct RecentEntry {
  std::filesystem::path path;  ///< absolute
  std::int64_t used_at = 0;    ///< seconds since 1970, UTC
  friend bool operator==(const RecentEntry&, const RecentEntry&) = default;
};

class RecentFiles {
 public:
  static constexpr std::size_t most = 24;

  explicit RecentFiles(std::filesystem::path file) : file_(std::move(file)) {}

  /// Latest first, without files that are gone. A file that is missing or broken gives none: the list is a
  /// convenience.
  std::vector<RecentEntry> load() const;
  /// Puts a path in front. Reads the file first: another window may have written it. Errors: E_FILE_WRITE.
  Result<Done> touch(const std::filesystem::path& path, std::int64_t now) const;

 private:
  std::vector<RecentEntry> read() const;

  std::filesystem::path file_;
};

}  // namespace hariko

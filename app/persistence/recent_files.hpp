#pragma once

// RecentFiles: list of the files that were opened or saved last, in a file that all windows share.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.hpp"

namespace hariko {

/// Entry of the list.
struct RecentEntry {
  std::filesystem::path path;  ///< absolute
  std::int64_t used_at = 0;    ///< seconds since 1970, UTC
  friend bool operator==(const RecentEntry&, const RecentEntry&) = default;
};

/// List of recent files.
class RecentFiles {
 public:
  static constexpr std::size_t most = 24;

  explicit RecentFiles(std::filesystem::path file) : file_(std::move(file)) {}

  /// Entries, latest first, without files that do not exist. A missing or broken list gives none, as it is a
  /// convenience.
  std::vector<RecentEntry> load() const;
  /// Moves a path to the front. Reads the list first, as another window may have written it. Errors:
  /// E_FILE_WRITE.
  Result<Done> touch(const std::filesystem::path& path, std::int64_t now) const;

 private:
  std::vector<RecentEntry> read() const;

  std::filesystem::path file_;
};

}  // namespace hariko

#pragma once

// CrashReports: reports of crashed sessions.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hariko {

/// Folder of crash reports, one file `crash-PROCESS.txt` for each crash until the user dismisses it; the last
/// dismissed one stays as crash.txt.
class CrashReports {
 public:
  struct Found {
    std::filesystem::path file;
    std::int64_t written_at = 0;  ///< seconds since 1970, UTC
    std::string text;
  };

  explicit CrashReports(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// File for this process's report in case of a crash. The folder need not exist.
  std::filesystem::path own_file() const;
  /// Latest report that was not dismissed.
  std::optional<Found> latest() const;
  /// Renames the latest report to crash.txt and removes older ones.
  void dismiss() const;

 private:
  /// All reports, latest first.
  std::vector<Found> all() const;

  std::filesystem::path folder_;
};

}  // namespace hariko

#pragma once

// CrashReports: what crashed sessions left behind about their end.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hariko {

/// One file a crash, `crash-PROCESS.txt`, until the user has dismissed it; the last one stays as crash.txt.
class CrashReports {
 public:
  struct Found {
    std::filesystem::path file;
    std::int64_t written_at = 0;  ///< seconds since 1970, UTC
    std::string text;
  };

  explicit CrashReports(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The file for this process's report, should it crash. The folder need not exist.
  std::filesystem::path own_file() const;
  /// The latest report that was not dismissed yet.
  std::optional<Found> latest() const;
  /// The latest is kept as crash.txt, older ones are removed.
  void dismiss() const;

 private:
  /// Latest first.
  std::vector<Found> all() const;

  std::filesystem::path folder_;
};

}  // namespace hariko

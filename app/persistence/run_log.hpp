#pragma once

// RunLog: log of the last runs, one line for each event, for error reports.

#include <filesystem>
#include <string>
#include <string_view>

namespace hariko {

/// Log file log.txt in a folder, with lines like "2026-11-25T16:02:11Z 4711 opened vase.hariko". All windows
/// write to the same file. Files are named without their folders, and the user's home folder is written as
/// "~". Failures to write are ignored.
class RunLog {
 public:
  /// Bytes, above which log.txt is renamed to log.old.txt.
  static constexpr std::size_t largest = 256 * 1024;

  /// An empty folder name logs nothing. The folder is created with the first line.
  explicit RunLog(std::filesystem::path folder);

  /// Appends a line.
  void line(std::string_view what, std::string_view text) const noexcept;
  /// Last lines, at most this number of bytes.
  std::string tail(std::size_t bytes) const;

 private:
  std::filesystem::path file_;  ///< empty: logs nothing
  std::string home_;
};

}  // namespace hariko

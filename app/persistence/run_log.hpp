#pragma once

// RunLog: what happened in the last runs, a line each, for reports about mistakes.

#include <filesystem>
#include <string>
#include <string_view>

namespace hariko {

/// "2026-11-25T16:02:11Z 4711 opened vase.hariko", in log.txt of the folder. All windows write to the same
/// file. Files are named without their folders, and the user's home folder is "~" wherever it is named. The
/// log never stands in the way: what cannot be written is left out.
class RunLog {
 public:
  static constexpr std::size_t largest = 256 * 1024;  ///< bytes; then log.txt becomes log.old.txt

  /// An empty folder logs nothing. It is made when the first line is written.
  explicit RunLog(std::filesystem::path folder);

  void line(std::string_view what, std::string_view text) const noexcept;
  /// The last lines, at most so many bytes.
  std::string tail(std::size_t bytes) const;

 private:
  std::filesystem::path file_;  ///< empty for none
  std::string home_;
};

}  // namespace hariko

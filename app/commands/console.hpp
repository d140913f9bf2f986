#pragma once

// Console output of commands: results go to the standard output, messages to the standard error stream.

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "core/base/message.hpp"
#include "core/base/progress.hpp"

namespace hariko {

inline constexpr Code e_output{"E_OUTPUT"};

/// Reports a message as "FILE: error E_PARSE: ..." on the standard error stream.
void report(std::string_view file, const Message& message);

/// Reports messages, one line for each kind with the count and the first elements.
void report(std::string_view file, std::span<const Message> messages);

/// Reports the error of a command; gives its exit code.
int failure(const std::filesystem::path& file, const Message& error);

/// Progress line on the standard error stream, only where that is a terminal. Destruction erases the line.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  /// Line "FILE: doing", with the file's name alone.
  ProgressLine(const std::filesystem::path& file, std::string_view doing);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// Progress to be updated by the work.
  const Progress& progress() const { return progress_; }

 private:
  void show();

  std::string what_;
  Progress progress_ = Progress::make();
  std::mutex mutex_;
  std::condition_variable ends_;
  bool ended_ = false;
  std::thread thread_;  ///< not running without a terminal
};

/// Writes text to the standard output and flushes it; false, after an error message, where that fails, as on
/// a full disk or a closed pipe.
bool print(std::string_view text);

/// Wall-clock times of the steps of a job.
class Stopwatch {
 public:
  Stopwatch();
  /// Milliseconds since the last call or the start.
  double lap();

 private:
  double last_;
};

}  // namespace hariko

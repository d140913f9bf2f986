#pragma once

// What subcommands write: results to the standard output, messages to the standard error stream.

#include <condition_variable>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>

#include "core/base/message.hpp"
#include "core/base/progress.hpp"

namespace hariko {

inline constexpr Code e_output{"E_OUTPUT"};

/// "FILE: error E_PARSE: ..." on the standard error stream.
void report(std::string_view file, const Message& message);

/// One line for each kind of message, with the count and the first elements.
void report(std::string_view file, std::span<const Message> messages);

/// Shows on the standard error stream how far some work is, where that is a terminal; the line goes when this
/// does.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  /// For the work.
  const Progress& progress() const { return progress_; }

 private:
  void show();

  std::string what_;
  Progress progress_ = Progress::make();
  std::mutex mutex_;
  std::condition_variable ends_;
  bool ended_ = false;
  std::thread thread_;  ///< not running where nobody looks
};

/// Writes and flushes the standard output; false (after an error message) when that fails, as on a full disk
/// or a closed pipe.
bool print(std::string_view text);

/// Wall-clock time of the steps of a job.
class Stopwatch {
 public:
  Stopwatch();
  /// Milliseconds since the last call or the start.
  double lap();

 private:
  double last_;
};

}  // namespace hariko

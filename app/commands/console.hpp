#pragma once

// What subcommands write: results to the standard output, messages to the standard error stream.

#include <string>
#include <string_view>

#include "core/base/message.hpp"

namespace hariko {

inline constexpr Code e_output{"E_OUTPUT"};

/// "FILE: error E_PARSE: ..." on the standard error stream.
void report(std::string_view file, const Message& message);

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

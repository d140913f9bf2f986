#pragma once

// Work in a child process, because damaged files can crash the kernel or make it loop for ever. Private to
// this folder.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// Time limits of the work, seconds.
struct Patience {
  double working = 20;  ///< processor time
  /// Time without any use of the processor: the work then waits for a lock that a thread held when the
  /// process was copied, and that nobody will release.
  double waiting = 60;
};

/// Runs `work` in a forked process and returns its bytes; nothing where it crashed, was cancelled, exceeded a
/// limit (it is then killed), or could not start. `work` should lock nothing that another thread can hold; it
/// reports progress through the function that it is given.
std::optional<std::string> isolated(
    const std::function<std::string(const std::function<void(double)>& report)>& work,
    const Patience& patience, const CancelToken& cancel, const Progress& progress);

/// Writes all bytes to a descriptor; false where that fails.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace hariko

#pragma once

// Work in a process of its own, for a kernel that damaged files can crash or send round in circles. Only for
// this folder.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// Limits of work, in seconds.
struct Patience {
  double working = 20;  ///< of a processor's time
  /// Without any of it: the work waits for a lock that nobody frees, as a thread held it that the copy of the
  /// process does not have.
  double waiting = 60;
};

/// Runs `work` in a copy of this process and gives its bytes; nothing where it crashed, was cancelled or came
/// to the end of a patience (then it is killed), or could not begin. `work` should lock nothing that another
/// thread can hold, and tells its progress by the function that it is given.
std::optional<std::string> isolated(
    const std::function<std::string(const std::function<void(double)>& report)>& work,
    const Patience& patience, const CancelToken& cancel, const Progress& progress);

/// False where not all of the bytes can be written.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace hariko

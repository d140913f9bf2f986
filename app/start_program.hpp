#pragma once

// Start of other programs.

#include <string>
#include <vector>

namespace hariko {

/// Starts another program, found on the path as by a shell, without this program's streams, so that readers
/// of these do not wait for its end. False where it cannot be started.
bool start_program(std::vector<std::string> command);

}  // namespace hariko

#pragma once

#include <string>
#include <vector>

namespace hariko {

/// Starts another program, found as a shell finds it, without our streams: whoever reads them must not wait
/// for it to end. False when it cannot be started.
bool start_program(std::vector<std::string> command);

}  // namespace hariko

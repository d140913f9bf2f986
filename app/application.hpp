#pragma once

// Application: the window, its loop, and the workers. Wiring only.

#include "app/window/window_options.hpp"

namespace hariko {

/// Opens the window and runs until it is closed. Gives the exit code: of a replay 1 when it ended otherwise
/// than it was recorded.
int run_window(const WindowOptions& options);

}  // namespace hariko

#pragma once

// Application: wiring of the window, its event loop and the workers.

#include "app/window/window_options.hpp"

namespace hariko {

/// Opens the window and runs until it is closed. Returns the exit code; 1 for a replay that ended in another
/// state than its recording.
int run_window(const WindowOptions& options);

}  // namespace hariko

#pragma once

// Application: the window, its loop, and the workers. Wiring only.

#include <filesystem>
#include <vector>

namespace hariko {

struct WindowOptions {
  std::vector<std::filesystem::path> files;  ///< the first is opened, further ones are added to it
  std::filesystem::path test_log;            ///< see TestLog; empty for none
  int width = 1440, height = 900;
};

/// Opens the window and runs until it is closed. Gives the exit code.
int run_window(const WindowOptions& options);

}  // namespace hariko

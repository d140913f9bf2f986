#pragma once

// Application: the window, its loop, and the workers. Wiring only.

#include <filesystem>
#include <vector>

namespace hariko {

struct WindowOptions {
  std::vector<std::filesystem::path> files;  ///< the first is opened, further ones are added to it
  std::filesystem::path test_log;            ///< see TestLog; empty for none
  std::filesystem::path record, replay;      ///< see ReplayRecorder and ReplayPlayer; empty for none
  bool skip_pauses = false;                  ///< of the replay
  int width = 1440, height = 900;
  double scale = 0;  ///< of the interface instead of the monitor's; 0 for the monitor's
};

/// Opens the window and runs until it is closed. Gives the exit code: of a replay 1 when it ended otherwise
/// than it was recorded.
int run_window(const WindowOptions& options);

}  // namespace hariko

#pragma once

// WindowOptions: command line options of the window.

#include <filesystem>
#include <string>
#include <vector>

namespace hariko {

/// Options of the window.
struct WindowOptions {
  std::vector<std::filesystem::path> files;  ///< the first is opened, further ones are added to it
  std::filesystem::path test_log;            ///< see TestLog; empty for none
  std::filesystem::path record, replay;      ///< see ReplayRecorder and ReplayPlayer; empty for none
  bool skip_pauses = false;                  ///< for the replay
  int width = 1440, height = 900;
  double scale = 0;  ///< scale of the interface instead of the monitor's; 0: the monitor's
};

/// Summary for the log, "vase.hariko, 1440 x 900", with files named without their folders.
inline std::string to_string(const WindowOptions& options) {
  std::string out;
  for (const std::filesystem::path& file : options.files) out += file.filename().string() + ", ";
  out += std::to_string(options.width) + " x " + std::to_string(options.height);
  if (options.scale > 0) out += ", scale " + std::to_string(options.scale);
  return options.record.empty() ? out : out + ", recording";
}

}  // namespace hariko

#pragma once

// SettingsFile: the user's settings, and what was chosen for exports, as JSON.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "ui/base/settings.hpp"
#include "ui/files/export_memory.hpp"

namespace hariko {

inline constexpr Code w_settings_broken{"W_SETTINGS_BROKEN"};
inline constexpr Code w_settings_value{"W_SETTINGS_VALUE"};

/// All settings as JSON, and back; what is missing or wrong has its default.
std::string settings_text(const Settings& settings);
Settings settings_of(std::string_view text);

/// Nothing in the file can keep the program from starting: what is missing or wrong has its default.
class SettingsFile {
 public:
  explicit SettingsFile(std::filesystem::path file) : file_(std::move(file)) {}

  struct Loaded {
    Settings settings;
    ExportMemory exports;
    /// W_SETTINGS_BROKEN: it is no JSON object; it was renamed, and the text says to what. W_SETTINGS_VALUE:
    /// names the members that were not used.
    std::vector<Message> problems;
  };
  Loaded load();
  /// Keeps members of the file that this version does not know, and mesh and CAD formats that `exports` does
  /// not have.
  /// Errors: E_FILE_WRITE.
  Result<Done> save(const Settings& settings, const ExportMemory& exports);

 private:
  std::filesystem::path file_;
  std::string kept_;  ///< text of the file that was loaded or saved last
};

}  // namespace hariko

#pragma once

// SettingsFile: the user's settings, and the choices of the export dialogs, as JSON.

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

/// JSON of all settings.
std::string settings_text(const Settings& settings);
/// Settings from JSON; missing or wrong members have their defaults.
Settings settings_of(std::string_view text);

/// File of settings. Nothing in it can keep the program from starting: missing or wrong members have their
/// defaults.
class SettingsFile {
 public:
  explicit SettingsFile(std::filesystem::path file) : file_(std::move(file)) {}

  /// Content of the file, with its problems.
  struct Loaded {
    Settings settings;
    ExportMemory exports;
    /// W_SETTINGS_BROKEN: the file was no JSON object and was renamed, to the name in the text.
    /// W_SETTINGS_VALUE: names the members that were not used. Errors of reading an existing file.
    std::vector<Message> problems;
  };
  /// Reads the file; defaults where there is none.
  Loaded load();
  /// Writes the settings. Keeps members of the file that this version does not know, and mesh and CAD formats
  /// that `exports` lacks. Errors: E_FILE_WRITE.
  Result<Done> save(const Settings& settings, const ExportMemory& exports);

 private:
  std::filesystem::path file_;
  std::string kept_;  ///< text of the file as last loaded or saved
};

}  // namespace hariko

#pragma once

// Command line options of all commands that write models for other programs. Internal to this folder.

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options of the file that is written.
class FileOptions {
 public:
  /// Adds --unit, --scale, --up, --origin, --ascii, --only, --offset, --thickness and --side.
  void add_to(CLI::App* command);
  /// Throws CLI::ValidationError for options that the format of `out` does not leave open.
  void check(const std::filesystem::path& out) const;
  /// Values of the options, after `check`.
  FileArguments arguments() const;

 private:
  std::string unit_, up_, origin_, side_;
  Wall wall_;
  double scale_ = 1;
  bool ascii_ = false;
  std::vector<std::string> only_;
};

}  // namespace hariko

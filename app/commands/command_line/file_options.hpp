#pragma once

// The options of all commands that write models for other programs. Internal to this folder.

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

class FileOptions {
 public:
  /// --unit, --scale, --up, --origin, --ascii, --only
  void add_to(CLI::App* command);
  /// Throws CLI::ValidationError where the format of `out` leaves no choice.
  void check(const std::filesystem::path& out) const;
  FileArguments arguments() const;

 private:
  std::string unit_, up_, origin_;
  double scale_ = 1;
  bool ascii_ = false;
  std::vector<std::string> only_;
};

}  // namespace hariko

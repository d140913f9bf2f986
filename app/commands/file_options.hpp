#pragma once

// The options of all commands that write models for other programs. Internal to app/commands.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"

namespace hariko {

class FileOptions {
 public:
  /// --unit, --scale, --up, --ascii, --only
  void add_to(CLI::App* command);
  /// Throws CLI::ValidationError where the format of `out` leaves no choice.
  void check(const std::filesystem::path& out) const;
  FileArguments arguments() const;

 private:
  std::string unit_, up_;
  double scale_ = 1;
  bool ascii_ = false;
  std::vector<std::string> only_;
};

/// The objects of these names, hidden ones included, and no others visible; all as they are when `only` is
/// empty. Error: E_NO_SUCH_OBJECT.
Result<Document> with_only(const Document& document, const std::vector<std::string>& only);

}  // namespace hariko

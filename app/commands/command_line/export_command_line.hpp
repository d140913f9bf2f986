#pragma once

// Command line options of `hariko export`. Internal to this folder.

#include <string>
#include <vector>

#include "app/commands/command_line/file_options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

/// Options of `hariko export`.
class ExportCommandLine {
 public:
  void add_to(CLI::App& app);
  CLI::App* command() const { return command_; }
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  ExportArguments arguments(const Construction& construction) const;

 private:
  CLI::App* command_ = nullptr;
  CLI::Option* density_ = nullptr;         ///< for triangles only
  std::vector<CLI::Option*> cad_options_;  ///< for STEP and IGES only
  ExportArguments arguments_;
  double angle_ = 0;  ///< degrees
  std::string quality_ = "balanced";
  FileOptions file_options_;
};

}  // namespace hariko

#pragma once

// Command line options of `hariko mesh`. Internal to this folder.

#include <optional>
#include <string>

#include "app/commands/command_line/file_options.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options of `hariko mesh`.
class MeshCommandLine {
 public:
  void add_to(CLI::App& app);
  CLI::App* command() const { return command_; }
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  MeshArguments arguments(const Construction& construction) const;

 private:
  CLI::App* command_ = nullptr;
  std::string file_, out_, start_ = "patches", split_ = "mid", errors_;
  std::optional<double> distance_, normal_, fold_, luminance_, max_edge_, min_angle_;  ///< angles in degrees
  bool json_ = false, optimise_ = false, balanced_ = false;
  FileOptions file_options_;
};

}  // namespace hariko

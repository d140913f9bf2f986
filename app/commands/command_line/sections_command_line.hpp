#pragma once

// Command line options of `hariko sections`. Internal to this folder.

#include <string>

#include "app/commands/sections_command.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options of `hariko sections`.
class SectionsCommandLine {
 public:
  void add_to(CLI::App& app);
  CLI::App* command() const { return command_; }
  /// Validates what the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  SectionsArguments arguments(const Construction& construction) const;

 private:
  CLI::App* command_ = nullptr;
  std::string file_, out_, across_ = "x", combs_ = "on";
  SectionsArguments arguments_;
};

}  // namespace hariko

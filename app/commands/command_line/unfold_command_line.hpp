#pragma once

// Command line options of `hariko unfold`. Internal to this folder.

#include <string>
#include <vector>

#include "app/commands/command_line/reading_command_line.hpp"
#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options of `hariko unfold`.
class UnfoldCommandLine {
 public:
  void add_to(CLI::App& app);
  CLI::App* command() const { return command_; }
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  UnfoldArguments arguments() const;

 private:
  CLI::App* command_ = nullptr;
  std::string file_, page_ = "A4", goal_ = "fewest", method_ = "search";
  std::vector<std::string> outs_;
  double height_ = 0, width_ = 0, depth_ = 0, flat_degrees_ = 0.5, merge_degrees_ = -1, distance_ = 0,
         normal_degrees_ = 0;
  UnfoldArguments arguments_;
  ReadingCommandLine reading_;
};

}  // namespace hariko

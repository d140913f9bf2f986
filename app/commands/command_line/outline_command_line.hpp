#pragma once

// The options of outlines, for all subcommands that make surfaces. Internal to this folder.

#include <string>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

class OutlineCommandLine {
 public:
  void add_to(CLI::App& command);
  /// After parsing.
  OutlineConstruction construction() const;

 private:
  std::string method_, sign_;
  std::optional<double> spacing_, gap_;
  std::optional<unsigned> count_;
};

}  // namespace hariko

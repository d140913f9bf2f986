#pragma once

// Command line options of outlines, for all commands that make surfaces. Internal to this folder.

#include <string>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options of outlines.
class OutlineCommandLine {
 public:
  void add_to(CLI::App& command);
  /// Values of the options, after parsing.
  OutlineConstruction construction() const;

 private:
  std::string method_, sign_;
  std::optional<double> spacing_, gap_;
  std::optional<unsigned> count_;
};

}  // namespace hariko

#pragma once

// Command line options for reading meshes of other programs.

#include <string>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options for reading meshes; several commands may have them.
class ReadingCommandLine {
 public:
  /// Adds the options to a command.
  void add_to(CLI::App& command);
  /// Values of the options, after parsing.
  Reading reading() const;

 private:
  std::string weld_ = none;
  bool repair_ = false, reference_ = false;
  static constexpr const char* none = "none";
};

}  // namespace hariko

#pragma once

// Command line options for the construction of surfaces. Internal to this folder.

#include <string>

#include "app/commands/command_line/outline_command_line.hpp"
#include "app/commands/command_line/reading_command_line.hpp"
#include "app/commands/command_line/solids_command_line.hpp"

namespace hariko {

/// Options of all commands that make surfaces.
class ConstructionCommandLine {
 public:
  void add_to(CLI::App& command);
  /// Values of the options, after parsing.
  Construction construction() const;

 private:
  std::string mode_, frames_, merge_coplanar_;
  bool round_ = false;  ///< obsolete option: mode G2 is round by itself
  OutlineCommandLine outlines_;
  SolidsCommandLine solids_;
  ReadingCommandLine reading_;
};

}  // namespace hariko

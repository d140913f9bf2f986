#pragma once

// The options of how surfaces are made, for all commands that make some. Internal to this folder.

#include <string>

#include "app/commands/command_line/outline_command_line.hpp"
#include "app/commands/command_line/reading_command_line.hpp"
#include "app/commands/command_line/solids_command_line.hpp"

namespace hariko {

class ConstructionCommandLine {
 public:
  void add_to(CLI::App& command);
  /// After parsing.
  Construction construction() const;

 private:
  std::string mode_, frames_, merge_coplanar_;
  bool round_ = false;  ///< asked for what mode G2 does anyway
  OutlineCommandLine outlines_;
  SolidsCommandLine solids_;
  ReadingCommandLine reading_;
};

}  // namespace hariko

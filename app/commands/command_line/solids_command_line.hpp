#pragma once

// Command line options of solids, for all commands that make surfaces. Internal to this folder.

#include <string>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Options of surfaces round solids.
class SolidsCommandLine {
 public:
  void add_to(CLI::App& command);
  /// Values of the options, after parsing.
  SolidsConstruction construction() const;

 private:
  std::string method_, ball_radius_, on_faces_, finer_;
  std::optional<double> rounding_, bridge_radius_;
};

}  // namespace hariko

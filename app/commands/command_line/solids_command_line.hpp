#pragma once

// The options of solids, for all subcommands that make surfaces. Internal to this folder.

#include <string>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

class SolidsCommandLine {
 public:
  void add_to(CLI::App& command);
  /// After parsing.
  SolidsConstruction construction() const;

 private:
  std::string method_, ball_radius_, on_faces_, finer_;
  std::optional<double> rounding_, bridge_radius_;
};

}  // namespace hariko

#pragma once

// Command line options for the construction of surfaces. Internal to this folder.

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

#pragma once

// Options of the commands of `hariko`. Internal to this folder.

#include <optional>
#include <string>
#include <vector>

#include "app/commands/command_line/construction_command_line.hpp"
#include "app/commands/command_line/file_options.hpp"
#include "app/commands/command_line/standard_streams.hpp"
#include "app/window/window_options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

/// Parser of one command, after `add_to` of the classes below.
class CommandOfLine {
 public:
  CLI::App* command() const { return command_; }

 protected:
  CLI::App* command_ = nullptr;
};

/// Options of `hariko export`.
class ExportCommandLine : public CommandOfLine {
 public:
  void add_to(CLI::App& app);
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  ExportArguments arguments(const Construction& construction) const;

 private:
  CLI::Option* density_ = nullptr;         ///< for triangles only
  std::vector<CLI::Option*> cad_options_;  ///< for STEP and IGES only
  ExportArguments arguments_;
  double angle_ = 0;  ///< degrees
  std::string quality_ = "balanced";
  FileOptions file_options_;
};

/// Options of `hariko mesh`.
class MeshCommandLine : public CommandOfLine {
 public:
  void add_to(CLI::App& app);
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  MeshArguments arguments(const Construction& construction) const;

 private:
  MeshArguments arguments_;
  std::string start_ = "patches", split_ = "mid";
  std::optional<double> normal_, fold_, min_angle_;  ///< degrees
  FileOptions file_options_;
};

/// Options of `hariko render`.
class RenderCommandLine : public CommandOfLine {
 public:
  void add_to(CLI::App& app);
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Draws a picture or a line drawing, depending on the file's name, after `check`. Returns the exit code.
  int run(const Construction& construction) const;

 private:
  void add_looks();
  void add_lines();
  /// Whether OUT is a picture, by its ending or by --format.
  bool is_picture() const;
  /// Whether OUT is a line drawing, by its ending or by --format.
  bool is_drawing() const;
  void check_picture() const;
  void check_environment() const;
  void check_making() const;
  void check_drawing() const;
  RenderArguments picture() const;
  DrawingArguments drawing() const;

  std::vector<CLI::Option*> picture_options_, drawing_options_;  ///< options of only one of the two
  std::string file_, out_, format_, size_ = "1280x960", view_ = "iso", saved_view_, map_ = "shaded",
                                    range_ = "symmetric", material_, colour_, wire_ = "none", section_,
                                    background_ = "dark", pull_;
  std::vector<std::string> show_, lines_;
  RenderArguments arguments_;
  std::optional<double> limit_;
  bool hidden_ = false;
};

/// Options of `hariko sections`.
class SectionsCommandLine : public CommandOfLine {
 public:
  void add_to(CLI::App& app);
  /// Validates what the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  SectionsArguments arguments(const Construction& construction) const;

 private:
  std::string across_ = "x", combs_ = "on";
  SectionsArguments arguments_;
};

/// Options of `hariko unfold`.
class UnfoldCommandLine : public CommandOfLine {
 public:
  void add_to(CLI::App& app);
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Values of the options, after `check`.
  UnfoldArguments arguments() const;

 private:
  std::string file_, page_ = "A4", goal_ = "fewest", method_ = "search";
  std::vector<std::string> outs_;
  double height_ = 0, width_ = 0, depth_ = 0, flat_degrees_ = 0.5, merge_degrees_ = -1, distance_ = 0,
         normal_degrees_ = 0;
  UnfoldArguments arguments_;
  ReadingCommandLine reading_;
};

/// Options of `hariko run`.
class ScriptCommandLine : public CommandOfLine {
 public:
  /// `streams`: what "-" stands for.
  void add_to(CLI::App& app, StandardStreams& streams);
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Runs the script, or prints the list; returns the exit code.
  int run() const;

 private:
  std::string file_, in_, out_;
  bool list_ = false, json_ = false;
  ReadingCommandLine reading_;
};

/// Options of the window.
class WindowCommandLine {
 public:
  void add_to(CLI::App& app);
  /// Throws CLI::ParseError where window options are combined with `command`.
  void check_nothing_said(const CLI::App& command) const;
  const WindowOptions& options() const { return options_; }

 private:
  WindowOptions options_;
  std::vector<const CLI::Option*> all_;
};

}  // namespace hariko

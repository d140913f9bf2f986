#pragma once

// Command line options of `hariko render`. Internal to this folder.

#include <optional>
#include <string>
#include <vector>

#include "app/commands/drawing_command.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

/// Options of `hariko render`.
class RenderCommandLine {
 public:
  void add_to(CLI::App& app);
  CLI::App* command() const { return command_; }
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

  CLI::App* command_ = nullptr;
  std::vector<CLI::Option*> picture_options_, drawing_options_;  ///< options of only one of the two
  std::string file_, out_, format_, size_ = "1280x960", view_ = "iso", saved_view_, map_ = "shaded",
                                    range_ = "symmetric", material_, colour_, wire_ = "none", section_,
                                    background_ = "dark", pull_;
  std::vector<std::string> show_, lines_;
  RenderArguments arguments_;
  std::optional<double> limit_;
  bool hidden_ = false;
};

}  // namespace hariko

#pragma once

// Command line options of the window, which are given without a command. Internal to this folder.

#include <vector>

#include "app/window/window_options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

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

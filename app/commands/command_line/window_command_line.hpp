#pragma once

// The options of the window, which stand without a command. Internal to this folder.

#include <vector>

#include "app/window/window_options.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hariko {

class WindowCommandLine {
 public:
  void add_to(CLI::App& app);
  /// Throws CLI::ParseError where something of this was said and `command` as well.
  void check_nothing_said(const CLI::App& command) const;
  const WindowOptions& options() const { return options_; }

 private:
  WindowOptions options_;
  std::vector<const CLI::Option*> all_;
};

}  // namespace hariko

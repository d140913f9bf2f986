#pragma once

// Options of how meshes of other programs are read.

#include <string>

#include "app/commands/commands.hpp"

namespace CLI {
class App;
}

namespace hariko {

/// Several commands may have the same ones.
class ReadingCommandLine {
 public:
  void add_to(CLI::App& command);
  Reading reading() const;

 private:
  std::string weld_ = none;
  bool repair_ = false, reference_ = false;
  static constexpr const char* none = "none";
};

}  // namespace hariko

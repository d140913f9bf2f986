#pragma once

// Command line options of `hariko run`. Internal to this folder.

#include <string>

#include "app/commands/command_line/reading_command_line.hpp"
#include "app/commands/command_line/standard_streams.hpp"

namespace hariko {

/// Options of `hariko run`.
class ScriptCommandLine {
 public:
  /// `streams`: what "-" stands for.
  void add_to(CLI::App& app, StandardStreams& streams);
  CLI::App* command() const { return command_; }
  /// Validates combinations that the parser itself cannot reject; throws CLI::ValidationError.
  void check() const;
  /// Runs the script, or prints the list; returns the exit code.
  int run() const;

 private:
  CLI::App* command_ = nullptr;
  std::string file_, in_, out_;
  bool list_ = false, json_ = false;
  ReadingCommandLine reading_;
};

}  // namespace hariko

#pragma once

// The commands that scripts may run, with their arguments, for people and for programs.

#include <string>

#include "ui/editor/command_table.hpp"

namespace hariko {

/// A line for each command, with its help, and an indented one for each argument.
std::string command_list_text(const CommandTable& table);

/// The same as JSON, as docs/cli.md describes it. Default lengths are in millimetres.
std::string command_list_json(const CommandTable& table);

}  // namespace hariko

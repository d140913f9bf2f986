#pragma once

// The file format of scripts: steps that run commands, as JSON. docs/cli.md describes it.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "ui/editor/command_arguments.hpp"

namespace hariko {

inline constexpr Code e_script{"E_SCRIPT"};

inline constexpr int script_version = 1;

/// One command with what is written for it.
struct ScriptStep {
  std::string command;
  std::vector<WrittenArgument> arguments;
};

/// Steps of a script, in the order in which they run.
using Script = std::vector<ScriptStep>;

/// Name of a step in messages, counted from 1: `step 3 "add.box"`; without the command where that is empty.
std::string step_text(std::size_t index, const std::string& command);

/// Reads a script. Errors: those of `parse_json` (not JSON, a member that appears twice, too long or deep);
/// E_SCRIPT (another format or version, a member that is missing, unknown or of another type; the text names
/// the step). O(text).
Result<Script> read_script(std::string_view text);

}  // namespace hariko

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
using ScriptStep = WrittenCommand;

struct Script {
  std::vector<ScriptStep> steps;  ///< in the order in which they run
  /// Number of edits that were made while the script was recorded, and that it does not have.
  std::size_t left_out = 0;
  std::vector<std::string> notes = {};  ///< for people: what was left out and where
};

/// Name of a step in messages, counted from 1: `step 3 "add.box"`; without the command where that is empty.
std::string step_text(std::size_t index, const std::string& command);

// Notes of recorded scripts: about the document that it begins with, an edit that is missing behind so many
// steps, and a file that was written there.
std::string note_of_beginning(const std::string& document);
std::string note_of_missing(std::size_t steps, const std::string& edit);
std::string note_of_file(std::size_t steps, const std::string& command);

/// Reads a script. Errors: those of `parse_json` (not JSON, a member that appears twice, too long or deep);
/// E_SCRIPT (another format or version, a member that is missing, unknown or of another type; the text names
/// the step). O(text).
Result<Script> read_script(std::string_view text);

/// Text of a script, with a line for each step. `read_script` reads the same script from it.
std::string write_script(const Script& script);

}  // namespace hariko

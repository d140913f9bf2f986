#pragma once

// The command line: `hariko info`, `export`, `render`, `evaluate`, `unfold`. docs/cli.md describes it.

#include <optional>

namespace hariko {

/// Runs the subcommand that the arguments name and gives the exit code: 0 fine, 1 the input or the job
/// failed, 2 usage.
/// --help and --version count as subcommands. Nothing when there is none, or only files: the window should
/// open with them. Writes to the standard streams.
std::optional<int> run_command(int argc, char** argv);

}  // namespace hariko

#pragma once

// The command line: the window, or `hariko info`, `export`, `render`, `mesh`, `evaluate`, `unfold`.
// docs/cli.md describes it.

#include <variant>

#include "app/window/window_options.hpp"

namespace hariko {

/// Parses the arguments and runs the command that they name. Gives its exit code (0 fine, 1 the input or the
/// job failed, 2 wrong usage; also after --help and --version), or the window that is asked for instead.
/// Writes to the standard streams.
std::variant<int, WindowOptions> run_command(int argc, char** argv);

}  // namespace hariko

#pragma once

// Command line of the program: the window, or `hariko info`, `export`, `render`, `mesh`, `evaluate`,
// `unfold`, `run`, as docs/cli.md describes.

#include <variant>

#include "app/window/window_options.hpp"

namespace hariko {

/// Parses the arguments and runs the command that they name. Returns its exit code (0 success, 1 failure of
/// the input or the job, 2 wrong usage; also after --help and --version), or the options of the window where
/// that is requested. Writes to the standard streams.
std::variant<int, WindowOptions> run_command(int argc, char** argv);

}  // namespace hariko

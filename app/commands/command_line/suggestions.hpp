#pragma once

// Suggestions where the command line names something that is not there. Internal to this folder.

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace hariko {

/// Why the first word on the command line cannot be meant as it stands: it is neither a command nor a file,
/// and does not look like the name of one, which has an ending or a folder. Names the nearest command.
std::optional<std::string> unknown_command(const CLI::App& app, const std::string& word);

/// "Did you mean '--density'?" for the first option that was not expected, on a line of its own; empty where
/// nothing is near. After parsing failed.
std::string suggested_option(const CLI::App& app);

}  // namespace hariko

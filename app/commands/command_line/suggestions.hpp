#pragma once

// Suggestions for misspelt commands and options. Internal to this folder.

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace hariko {

/// Message, with the nearest command, for a first word that is neither a command nor a file and does not look
/// like a file's name, which has an ending or a folder. Nothing for other words.
std::optional<std::string> unknown_command(const CLI::App& app, const std::string& word);

/// Suggestion "Did you mean '--density'?", on a line of its own, for the first unexpected option after
/// parsing failed; empty where no option is similar.
std::string suggested_option(const CLI::App& app);

}  // namespace hariko

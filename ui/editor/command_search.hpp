#pragma once

// Searching the command table in the language of the interface and in English.

#include <span>

#include "ui/base/language.hpp"
#include "ui/editor/command_table.hpp"

namespace hariko {

/// Commands that match, best first: by label, other names, menu and help. Of equal ones, and for an empty
/// query, those that were `recent`ly used (ids, latest first) come first, then the order of the table.
std::vector<const Command*> search_commands(const CommandTable& table, const Language& language,
                                            std::string_view query, std::span<const std::string> recent);

}  // namespace hariko

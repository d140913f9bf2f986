#pragma once

// Check that a command does not overwrite its input. Internal to this folder.

#include <filesystem>

namespace hariko {

/// Throws CLI::ValidationError where a command would overwrite its input.
void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out);

}  // namespace hariko

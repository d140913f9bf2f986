#pragma once

#include <filesystem>

namespace hariko {

/// Throws CLI::ValidationError where a command would overwrite its input.
void check_distinct(const std::filesystem::path& in, const std::filesystem::path& out);

}  // namespace hariko

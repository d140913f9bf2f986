#pragma once

// Names of files in sessions and messages.

#include <filesystem>
#include <string>

#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

/// Absolute, normalised path: recovery copies, recent files and locks must not depend on the working folder.
inline std::filesystem::path full_path(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path full = std::filesystem::absolute(path, error);
  return error ? path : full.lexically_normal();
}

/// Name of a file for sentences, shortened.
inline std::string name_of(const std::filesystem::path& path) {
  return shortened(path.filename().string(), 200);
}

}  // namespace hariko

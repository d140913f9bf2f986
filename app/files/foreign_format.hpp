#pragma once

// Files of other programs that are not read: which they are, and what to export instead.

#include <filesystem>

#include "core/base/message.hpp"

namespace hariko {

/// The ending is that of a format of other programs that is not read.
bool has_foreign_ending(const std::filesystem::path& file);
/// E_FORMAT_UNKNOWN, told by the ending of the name.
Message foreign_format(const std::filesystem::path& file);

}  // namespace hariko

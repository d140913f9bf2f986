#pragma once

// File formats of other programs that are not supported, with advice on what to export instead.

#include <filesystem>

#include "core/base/message.hpp"

namespace hariko {

/// Whether the ending is that of an unsupported format of another program.
bool has_foreign_ending(const std::filesystem::path& file);
/// E_FORMAT_UNKNOWN with advice, by the ending of the name.
Message foreign_format(const std::filesystem::path& file);

}  // namespace hariko

#pragma once

// Names of files as text that any reader of JSON accepts: paths are bytes and need not be UTF-8.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// "file:///home/a%20b.hariko" of an absolute path: every byte but letters, digits and -._~/ is escaped (RFC
/// 8089).
std::string file_uri(const std::filesystem::path& path);

/// The path of such a text; nothing when it is not an absolute file URI of this machine.
std::optional<std::filesystem::path> path_of_uri(std::string_view uri);

/// Every %AB as the byte that it stands for; nothing where one is cut off or zero.
std::optional<std::string> without_escapes(std::string_view text);

}  // namespace hariko

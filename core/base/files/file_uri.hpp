#pragma once

// File URIs: file names as text that any reader of JSON accepts; paths are bytes and need not be UTF-8.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// File URI of an absolute path, such as "file:///home/a%20b.hariko": every byte but letters, digits and
/// -._~/ is escaped (RFC 8089).
std::string file_uri(const std::filesystem::path& path);

/// Path of a file URI; nothing when it is not an absolute file URI of this machine.
std::optional<std::filesystem::path> path_of_uri(std::string_view uri);

/// Decodes percent escapes: every %AB becomes the byte that it stands for; nothing where an escape is
/// incomplete or zero.
std::optional<std::string> without_escapes(std::string_view text);

}  // namespace hariko

#pragma once

// Formats of files by their content, and formats of other programs that are not read, with advice on what to
// export instead.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/message.hpp"

namespace hariko {

/// Whether the ending is that of an unsupported format of another program.
bool has_foreign_ending(const std::filesystem::path& file);
/// E_FORMAT_UNKNOWN with advice, by the ending of the name.
Message foreign_format(const std::filesystem::path& file);

/// Ending, without its point, of files with such content: "obj", "off", "ply", "stl", "glb", "gltf", "3mf",
/// "step", "iges", "hariko" or, for other JSON, "json". Nothing where the bytes tell no format. O(size).
std::optional<std::string> ending_of_content(std::string_view bytes);

}  // namespace hariko

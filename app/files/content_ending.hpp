#pragma once

// Formats of files by their content, for names that do not tell them.

#include <optional>
#include <string>
#include <string_view>

namespace hariko {

/// Ending, without its point, of files with such content: "obj", "off", "ply", "stl", "glb", "gltf", "3mf",
/// "step", "iges", "hariko" or, for other JSON, "json". Nothing where the bytes tell no format. O(size).
std::optional<std::string> ending_of_content(std::string_view bytes);

}  // namespace hariko

#pragma once

// Reading the origin of a scene, skin or outline in a separate file.

#include <string_view>

#include "core/base/result.hpp"
#include "core/base/vector.hpp"

namespace hariko {

/// Reads the member "origin" of a separate file of solids, sections or loops: the point that its positions
/// are relative to, zero without it. Errors: E_LIMIT, E_PARSE, E_SCHEMA. O(text).
Result<Vector3> read_origin(std::string_view text);

}  // namespace hariko

#pragma once

// Reading skins in the plain layout for sections drawn in other programs: points of sections and path as rows
// of numbers, links and merges by strip and indices.

#include <string_view>

#include "core/base/result.hpp"
#include "core/skinning/skin.hpp"

namespace hariko {

/// Reads a skin from text in the plain layout; sections are reversed where needed so that all have the same
/// direction (see `turn_sections`). Errors: E_LIMIT, E_PARSE, E_SCHEMA, E_INDEX.
Result<Skin> read_skin_layout(std::string_view text);

}  // namespace hariko

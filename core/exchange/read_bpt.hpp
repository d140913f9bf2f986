#pragma once

// Reader of Bezier patch files (*.bpt), the text form in which the teapot is passed round.

#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/surface/bicubic_patch.hpp"

namespace hariko {

inline constexpr std::size_t max_bpt_patches = 100'000;

/// The number of patches; for each one its degrees, "3 3", and 16 points, row by row. One net a patch.
/// Errors: E_EMPTY, E_PARSE, E_TRUNCATED, E_LIMIT, and E_FORMAT_UNKNOWN where a patch is not bicubic; they
/// name the line.
Result<std::vector<BicubicNet>> read_bpt(std::string_view text);

}  // namespace hariko

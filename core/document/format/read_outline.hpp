#pragma once

// Reading outlines from separate files.

#include <string_view>

#include "core/base/result.hpp"
#include "core/gaussmap/outlines/outline_settings.hpp"

namespace hariko {

/// Largest number of points of an outline, more than any drawn outline has; tests of convexity compare all
/// pairs.
inline constexpr std::size_t max_outline_points = 20000;

/// Reads a separate outline file: {"loops": [{"points": [[x, y, z], ...], "normals": [...], "K": [...]}]}; K,
/// the Gaussian curvature, is optional. Errors: E_LIMIT, E_PARSE, E_SCHEMA. `check_outline` checks the
/// geometry.
Result<Outline> read_outline(std::string_view text);

}  // namespace hariko

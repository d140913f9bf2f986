#pragma once

// Overlap test for convex polygons of a sheet.

#include <span>

#include "core/base/vector.hpp"

namespace hariko {

/// Penetration that still counts as touching, relative to the longest edge of the sheet: facets round a flat
/// vertex touch up to rounding.
inline constexpr double overlap_tolerance = 1e-9;

/// Whether two convex polygons overlap: no edge line of either separates them, up to a penetration of
/// `tolerance` (unit of the corners, >= 0). Both run counter-clockwise. Exact for the given doubles:
/// floating-point filter with an error bound, then exact expansions of doubles where it does not decide.
/// Covers crossing edges, containment and coincidence alike. Coordinates that are not zero must lie between
/// 1e-60 and 1e60 in magnitude.
bool overlaps(std::span<const Vector2> first, std::span<const Vector2> second, double tolerance);

}  // namespace hariko

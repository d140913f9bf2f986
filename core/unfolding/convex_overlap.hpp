#pragma once

// Whether two convex polygons of a sheet overlap.

#include <span>

#include "core/base/vector.hpp"

namespace hariko {

/// What may be taken for touching: 1e-9 of the longest edge of the sheet. Flat vertices make facets touch
/// with rounding noise.
inline constexpr double overlap_tolerance = 1e-9;

/// True when no edge line of either polygon has the other one beyond it, up to a penetration of `tolerance`
/// (same unit as the corners, >= 0). Both run counter-clockwise. Decided exactly for the given doubles: by
/// doubles with a bound on their error, and where that does not tell, by exact sums of doubles. Covers
/// crossing edges, containment and coincidence alike. Coordinates that are not zero lie between 1e-60 and
/// 1e60 in magnitude.
bool overlaps(std::span<const Vector2> first, std::span<const Vector2> second, double tolerance);

}  // namespace hariko

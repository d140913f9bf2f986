#pragma once

// Diagonals of polygons that need not be planar or convex.

#include <span>

#include "core/base/vector.hpp"

namespace hariko {

/// Whether the line between corners i and j runs inside the polygon, judged in its mean plane. Neighbouring
/// corners have no diagonal between them. In polygons that are convex or have no area every diagonal counts
/// as inside. O(n), O(n log n) to find out that a polygon is convex.
bool is_inner_diagonal(std::span<const Vector3> corners, std::size_t i, std::size_t j);

}  // namespace hariko

#pragma once

// The shape of one polygon that need not be planar, judged in its mean plane.

#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Newell's normal of the closed polygon: direction of the mean plane, length twice the projected area. Taken
/// about the first corner, so that a polygon far from zero is as precise as one at zero.
Vector3 newell_normal(std::span<const Vector3> corners);

enum class FaceShape { convex, concave, self_crossing };

/// Projects the corners along Newell's normal (where that vanishes, onto the plane of the two longest
/// independent diagonals). `self_crossing`: two sides cross inside both. `concave`: a corner turns inwards by
/// a triangle of more than 1e-4 of the polygon's area (the reflex test of kuriyama.md section 11). Polygons
/// within a line are convex. Typically O(n log n) in the number of corners; the search for crossings stops
/// after 2,000,000 pairs of sides.
FaceShape classify_face(std::span<const Vector3> corners);

}  // namespace hariko

#pragma once

// Orientation predicate: the side of a plane on which a point lies, exactly.

#include "core/base/vector.hpp"

namespace hariko {

/// Orientation of four points, the sign of det(b - a, c - a, d - a): 1 where d lies on the side from which a,
/// b, c turn counter-clockwise, 0 in the plane. Exact for coordinates between 1e-60 and 1e60 in magnitude, or
/// zero.
int side_of_plane(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d);

}  // namespace hariko

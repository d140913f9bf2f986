#pragma once

// Clusters of vertices at the same position, or nearly.

#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Representative of each point: in the order of the points, a point within `distance` (>= 0) of an earlier
/// representative gets the nearest one (the earliest of equally near ones); any other point is its own
/// representative. Non-finite points always represent themselves; distances below 1e-290 of the largest
/// coordinate count as 0. O(points) expected.
std::vector<Index> representatives(std::span<const Vector3> points, double distance);

}  // namespace hariko

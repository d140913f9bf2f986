#pragma once

// Vertices that lie at the same place, or nearly.

#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// For each point the first point that stands for it: walking the points in order, a point within `distance`
/// (>= 0) of an earlier standing one gets the nearest such (the earliest of equally near ones), any other
/// stands for itself. Non-finite points always stand for themselves; distances below 1e-290 of the largest
/// coordinate count as 0. O(points) expected.
std::vector<Index> representatives(std::span<const Vector3> points, double distance);

}  // namespace hariko

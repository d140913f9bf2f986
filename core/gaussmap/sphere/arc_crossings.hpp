#pragma once

// Intersection test of great-circle arcs.

#include <optional>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// First pair of arcs that meet anywhere but at a shared end; arcs are numbered through all loops, arc i runs
/// from point i to the next of its loop. Arcs must be shorter than 90 degrees. Expected O(arcs) for arcs of
/// similar length.
std::optional<std::pair<Index, Index>> crossing_arcs(const std::vector<std::vector<Vector3>>& loops);

}  // namespace hariko

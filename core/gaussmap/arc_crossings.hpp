#pragma once

// Whether arcs of great circles cross each other.

#include <optional>
#include <utility>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// The first pair of arcs that meet otherwise than at an end that they share; arcs are numbered through all
/// loops, arc i runs from point i to the next of its loop. Arcs are shorter than 90 degrees. Expected O(arcs)
/// for arcs of like lengths.
std::optional<std::pair<Index, Index>> crossing_arcs(const std::vector<std::vector<Vector3>>& loops);

}  // namespace hariko

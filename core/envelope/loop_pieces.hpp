#pragma once

// Cuts a face of a cage into pieces that patches can fill: quads with corners neither flat nor sharp where
// that is possible (spec 3.1b.6).

#include <functional>
#include <span>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// How badly a loop is shaped: 0 for a rectangle. `outside`: the normal of the face that it is a piece of.
double piece_cost(std::span<const Vector3> loop, const Vector3& outside);

/// Places in the loop, one list a piece. `allowed(i, j)`: a diagonal may join the two. The cheapest partition
/// by diagonals for loops of up to ten corners; longer ones are halved first, greedily.
std::vector<std::vector<Index>> cheapest_pieces(std::span<const Vector3> loop, const Vector3& outside,
                                                const std::function<bool(Index, Index)>& allowed);

}  // namespace hariko

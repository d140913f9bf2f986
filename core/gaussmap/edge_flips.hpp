#pragma once

// Edges of a triangulation flipped until no other diagonal is better. Internal to core/gaussmap.

#include <array>
#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Whether the triangles (p, q, r) and (q, p, s) had better have the edge r s than p q.
using BetterDiagonal = std::function<bool(Index p, Index q, Index r, Index s)>;

/// The triangles with edges flipped where `better` says so, again and again. Edges of the border stay, so do
/// edges at vertices with `fewest_edges` of them, and none is made that is there already: a manifold stays
/// one. `better` has to lead to an end; whatever it does, there are at most ten flips an edge. O(triangles)
/// where few are flipped.
std::vector<std::array<Index, 3>> flip_edges(std::vector<std::array<Index, 3>> triangles, Index vertex_count,
                                             Index fewest_edges, const BetterDiagonal& better);

}  // namespace hariko

#pragma once

// Edge flips in a triangulation until no other diagonal is better. Internal to core/gaussmap.

#include <array>
#include <functional>
#include <vector>

#include "core/base/vector.hpp"

namespace hariko {

/// Whether for the triangles (p, q, r) and (q, p, s) the edge r s is better than p q.
using BetterDiagonal = std::function<bool(Index p, Index q, Index r, Index s)>;

/// Returns the triangles with edges flipped repeatedly where `better` says so. Edges of the border stay, and
/// so do edges at vertices with only `fewest_edges` of them; no existing edge is made twice: a manifold stays
/// one. `better` should lead to termination; in any case the number of flips is at most ten times that of the
/// edges. O(triangles) where few are flipped.
std::vector<std::array<Index, 3>> flip_edges(std::vector<std::array<Index, 3>> triangles, Index vertex_count,
                                             Index fewest_edges, const BetterDiagonal& better);

}  // namespace hariko

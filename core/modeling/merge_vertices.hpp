#pragma once

// Merging vertices: several become one, faces that lose too many corners vanish.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

/// Where the merged vertex lies, and whose id, tension and tag it has: `centre` (of the given places; the
/// first's id), `first` or `last` in the order given.
enum class MergeAt { centre, first, last };

// Edges that come to lie on each other keep the shaping of the one that was there, or else of the lowest.
// Selects the merged vertices. Errors of all: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (fewer
// than two vertices would be merged), E_NO_FACES, E_WOULD_BE_NONMANIFOLD (a face would pass a vertex twice,
// an edge would have three faces, parts would touch in a vertex).

/// All given vertices become one. Of repeated ids the first counts (for `last`: the last).
Result<Modeled> merge_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices,
                               MergeAt at);

/// Edges shrink to points: the ends of edges that hang together become one vertex at their centre.
Result<Modeled> collapse_edges(const PolyhedronSource& source, std::span<const EdgeId> edges);

/// Of the given vertices, walked by ascending id, one within `distance` of an earlier one is merged with it,
/// and the earlier one stays where it is (`representatives`): stitches borders that lie on each other.
/// Errors: E_BAD_AMOUNT (distance negative or not finite).
Result<Modeled> merge_by_distance(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  double distance);

}  // namespace hariko

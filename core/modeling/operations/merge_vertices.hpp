#pragma once

// Merging vertices into one; faces left with too few corners are removed.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Position, id, tension and tag of the merged vertex: `centre` (mean of the given positions; the first
/// vertex's id), `first` or `last` in the order given.
enum class MergeAt { centre, first, last };

// Edges that coincide after merging keep the shaping of the one whose ends did not change, or else of the
// lowest. Selects the merged vertices. Errors of all three functions: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT,
// E_WRONG_SELECTION (fewer than two vertices would be merged), E_NO_FACES, E_WOULD_BE_NONMANIFOLD (a face
// would pass a vertex twice, an edge would have three faces, parts would touch in a vertex).

/// Merges all given vertices into one. Of repeated ids the first counts (for `last`: the last).
Result<EditResult> merge_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                  MergeAt at);

/// Collapses edges: the ends of connected edges become one vertex at their centre.
Result<EditResult> collapse_edges(const PolyhedronSource& source, std::span<const EdgeId> edges);

/// Merges each given vertex, by ascending id, with an earlier one within `distance`; the earlier one stays
/// where it is (`representatives`). Stitches borders that coincide. Errors: E_BAD_AMOUNT (distance negative
/// or not finite).
Result<EditResult> merge_by_distance(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                     double distance);

}  // namespace hariko

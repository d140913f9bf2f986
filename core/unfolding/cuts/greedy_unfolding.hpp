#pragma once

// Greedy starts of the search for cuts: growing pieces facet by facet, or joining them, without any overlap
// (unfolding.md, "The method that is used"). Internal to core/unfolding.

#include "core/base/cancellation.hpp"
#include "core/unfolding/cuts/facet_forest.hpp"

namespace hariko {

/// Priority in which facets or pieces are joined.
enum class GrowthOrder { long_edges, flat_edges, first_come, round, shuffled };

/// Order and seed of a start.
struct Growth {
  GrowthOrder order = GrowthOrder::long_edges;
  std::uint64_t seed = 0;  ///< for the first facet or the shuffle; equal seeds give equal pieces
};

/// Prim's algorithm on the dual graph: attaches a facet where it overlaps no facet of the piece and fits; a
/// facet that cannot be attached starts a new piece. The forest must be empty. O(facets log facets) for
/// facets of about equal size.
void grow(FacetForest& forest, const Growth& growth, const CancelToken& cancel);

/// Kruskal's algorithm: makes every facet a piece, then joins them as `join_pieces` does. The forest must be
/// empty. `first_come` and `round` mean the order of the edges here. As the smaller piece always moves,
/// O(facets log facets) for facets of about equal size.
void gather(FacetForest& forest, const Growth& growth, const CancelToken& cancel);

/// Joins pieces over cut edges, in the given order, until no edge allows it.
void join_pieces(FacetForest& forest, const Growth& growth, const CancelToken& cancel);

}  // namespace hariko

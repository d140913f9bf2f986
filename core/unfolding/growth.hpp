#pragma once

// Growing pieces facet by facet, and joining them, so that nothing ever overlaps (unfolding.md, "The method
// that is used"). Internal to core/unfolding.

#include "core/base/cancellation.hpp"
#include "core/unfolding/facet_forest.hpp"

namespace hariko {

/// What is joined first.
enum class GrowthOrder { long_edges, flat_edges, first_come, round, shuffled };

struct Growth {
  GrowthOrder order = GrowthOrder::long_edges;
  std::uint64_t seed = 0;  ///< of the first facet, or of the shuffle; the same one gives the same pieces
};

/// Prim's algorithm on the graph of facets: a facet is attached where it overlaps no facet of the piece and
/// fits; what cannot be attached begins a piece of its own. The forest is empty before. O(facets log facets)
/// for facets of even size.
void grow(FacetForest& forest, const Growth& growth, const CancelToken& cancel);

/// Kruskal's algorithm: every facet is a piece, then they are joined as by `join_pieces`. The forest is empty
/// before. Orders `first_come` and `round` mean the order of the edges here. As a smaller piece moves to a
/// larger one, O(facets log facets) for facets of even size.
void gather(FacetForest& forest, const Growth& growth, const CancelToken& cancel);

/// Joins pieces over cut edges in this order until no edge allows it.
void join_pieces(FacetForest& forest, const Growth& growth, const CancelToken& cancel);

}  // namespace hariko

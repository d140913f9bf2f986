#pragma once

// The method of Yamamoto and Saitoh (section 5) as the paper has it, made precise in unfolding.md. A
// reference: it leaves overlaps and many pieces on real shapes; `search_cuts` is the method to use.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/unfolding/facet_layout.hpp"

namespace hariko {

/// Section 5.1: border edges, and of each facet the interior edge with the largest fold, unless a facet there
/// has two cuts already. 1 for each such edge.
std::vector<std::uint8_t> initial_cuts(const FacetGraph& graph);

/// Facets are placed once each, breadth first over edges that are no initial cuts; edges that were not
/// crossed are cuts too.
Folds unfold_over(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts);

/// Section 5.2, case 1: inner vertices whose angles sum to more than 2 pi (border vertices: likewise), which
/// need two cuts (one) at least. Ascending.
std::vector<Index> vertices_needing_two_cuts(const FacetGraph& graph);

/// Section 5.2, case 2, at an inner edge whose cut ends in `tip`: theta1 - pi > 2 (2 pi - theta2), with the
/// sums of angles theta2 at the tip and theta1 at the other end on the side of the edge's first facet up to
/// the next cut or all round. The figure is lost, so this is a heuristic and serves for the order of repairs
/// only.
bool tip_would_overlap(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts, Index edge, Index tip);

struct ReferenceUnfolding {
  Folds folds;
  std::size_t overlapping_pairs = 0;  ///< that the repair left
  int rounds = 0;                     ///< of repair
};

/// The whole: initial cuts, unfolding, exact test, and repair: an initial cut of an overlapping facet becomes
/// a fold again and all is unfolded anew, at most 60 times. Errors: E_CANCELLED.
Result<ReferenceUnfolding> reference_unfolding(const FacetGraph& graph,
                                               const std::vector<FacetCorners>& shapes,
                                               const CancelToken& cancel = {});

}  // namespace hariko

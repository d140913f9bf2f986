#pragma once

// Method of Yamamoto and Saitoh (section 5) as published, made precise in unfolding.md. For reference only:
// it leaves overlaps and many pieces on real shapes; use `search_cuts`.

#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/result.hpp"
#include "core/unfolding/cuts/facet_layout.hpp"

namespace hariko {

/// Initial cuts (section 5.1): border edges and, for each facet, its interior edge with the largest fold,
/// unless a facet there has two cuts already. 1 for each such edge.
std::vector<std::uint8_t> initial_cuts(const FacetGraph& graph);

/// Unfolding over edges that are not initial cuts, breadth first, each facet placed once; edges that were not
/// crossed become cuts too.
Folds unfold_over(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts);

/// Heuristic for overlap at the end `tip` of a cut, at an inner edge (section 5.2, case 2): theta1 - pi > 2
/// (2 pi - theta2), with the angle sums theta2 at the tip and theta1 at the other end on the side of the
/// edge's first facet, up to the next cut or all round. The paper's figure is lost, so it serves only to
/// order repairs.
bool tip_would_overlap(const FacetGraph& graph, const std::vector<std::uint8_t>& cuts, Index edge, Index tip);

/// Result of the reference method.
struct ReferenceUnfolding {
  Folds folds;
  std::size_t overlapping_pairs = 0;  ///< remaining after the repair
  int rounds = 0;                     ///< rounds of repair
};

/// Complete method: initial cuts, unfolding, exact overlap test, and repair, which turns an initial cut of an
/// overlapping facet back into a fold and unfolds anew, at most 60 times. Errors: E_CANCELLED.
Result<ReferenceUnfolding> reference_unfolding(const FacetGraph& graph,
                                               const std::vector<FacetCorners>& shapes,
                                               const CancelToken& cancel = {});

}  // namespace hariko

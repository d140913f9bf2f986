#pragma once

// Search for the cuts of an unfolding: overlap-free growth from several starts, then the ejection search
// (unfolding.md, "The method that is used").

#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/unfolding/cuts/facet_forest.hpp"

namespace hariko {

/// Limits of the search.
struct CutSearch {
  std::optional<PaperSize> room = {};  ///< largest size of a piece, in the unit of the shapes; nothing: any
  std::uint64_t steps = 300'000;       ///< budget of the ejection search; 0 skips it
};

/// Layouts without overlaps, as candidates for the goal: first those of the starts, then ever fewer pieces;
/// the last has the fewest. Deterministic: depends on the arguments alone, never on time. Errors:
/// E_CANCELLED. O(facets log facets) for facets of about equal size, plus O(steps).
Result<std::vector<Folds>> search_cuts(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                                       const EdgeRules& rules, const CutSearch& search,
                                       const CancelToken& cancel = {}, const Progress& progress = {});

/// Rules that a search must keep: flat faces of the mesh stay whole, the designer's cuts and folds, and
/// coplanar facets up to `merge_angle` (radians) stay together as one polygon. `wishes` is empty or has one
/// rule for each edge. A fold that would close a cycle, overlap or not fit becomes free; the designer's folds
/// have priority.
EdgeRules settled_rules(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                        const EdgeRules& wishes, double merge_angle, std::optional<PaperSize> room);

/// Tolerance of the search's overlap test, in the unit of the shapes: half of the final one, so that rounding
/// when a piece is moved does not matter.
double search_tolerance(const std::vector<FacetCorners>& shapes);

/// Number of pieces for given folds. O(edges).
std::size_t piece_count(const FacetGraph& graph, const Folds& folds);

}  // namespace hariko

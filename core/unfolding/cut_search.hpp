#pragma once

// Where to cut: overlap-free growth from several starts, then the ejection search (unfolding.md, "The method
// that is used").

#include <optional>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/unfolding/facet_forest.hpp"

namespace hariko {

struct CutSearch {
  std::optional<PaperSize> room = {};  ///< that a piece may take, in the unit of the shapes
  std::uint64_t steps = 300'000;       ///< of the ejection search; 0 leaves it out
};

/// Layouts without overlaps, each a candidate for what is wanted: those of the starts first, then ever fewer
/// pieces; the last one has the fewest. A function of the arguments alone, never of time. Errors:
/// E_CANCELLED. O(facets log facets) for facets of even size, and O(steps).
Result<std::vector<Folds>> search_cuts(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                                       const EdgeRules& rules, const CutSearch& search,
                                       const CancelToken& cancel = {}, const Progress& progress = {});

/// Rules that a search must keep: flat faces of the mesh, the designer's cuts and folds, and facets that lie
/// in one plane up to `merge_angle` (radians), which are one polygon. `wishes` is empty or has one rule for
/// each edge. A fold that would close a cycle, overlap or not fit is free instead; the designer's come first.
EdgeRules settled_rules(const FacetGraph& graph, const std::vector<FacetCorners>& shapes,
                        const EdgeRules& wishes, double merge_angle, std::optional<PaperSize> room);

/// What the overlap test of a search takes for touching: half of what is allowed in the end, so that rounding
/// when a piece is moved does not matter. In the unit of the shapes.
double search_tolerance(const FacetGraph& graph, const std::vector<FacetCorners>& shapes);

/// Pieces that these folds leave. O(edges).
std::size_t piece_count(const FacetGraph& graph, const Folds& folds);

}  // namespace hariko

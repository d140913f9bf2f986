#pragma once

// Conversion between a paper model as the document stores it and its layout on a mesh.

#include <span>

#include "core/document/paper_model.hpp"
#include "core/unfolding/unfolding.hpp"

namespace hariko {

/// Paper model to be stored for a layout. `names` has one name for each vertex of the mesh; vertices with
/// equal names are not stored. Objects, tolerances, goal and unknown members are copied from `before`.
/// O(facets log facets).
PaperModel kept_of(const Unfolding& unfolding, std::span<const PaperVertex> names, const PaperModel& before);

/// Layout of a stored paper model on a mesh that may have changed since. Edges that still exist are folded
/// and cut as before, flat faces stay whole, and facets that still exist keep their places. New facets are
/// joined to existing ones where that overlaps nothing, and pieces without a place are packed. On the same
/// mesh a layout is restored exactly: folds, and corners bit for bit. Errors: those of `check_settings`.
/// O(facets log facets).
Result<Unfolding> restored(const PaperModel& paper, std::shared_ptr<const FacetGraph> graph,
                           std::span<const PaperVertex> names);

/// Designer's cuts and folds that still exist, for a new search.
EdgeRules wishes_on(const PaperModel& paper, const FacetGraph& graph, std::span<const PaperVertex> names);

}  // namespace hariko

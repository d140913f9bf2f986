#pragma once

// Between a paper model as the document keeps it and its layout on a mesh.

#include <span>

#include "core/document/paper_model.hpp"
#include "core/unfolding/unfolding.hpp"

namespace hariko {

/// What of a layout the designer's document keeps. `names` has one for each vertex of the mesh; vertices that
/// share a name have none. Objects, tolerances, goal and unknown members are those of `before`.
/// O(facets log facets).
PaperModel kept_of(const Unfolding& unfolding, std::span<const PaperVertex> names, const PaperModel& before);

/// The layout of a paper model on a mesh, which may have changed since: edges that are still there are folded
/// and cut as they were, flat faces are whole, and facets that are still there lie where they lay. Facets
/// that are new are joined to what is there where that overlaps nothing, and what has no place is packed. A
/// layout that was kept on the same mesh comes back: folds and corners bit for bit. Errors: those of
/// `check_settings`. O(facets log facets).
Result<Unfolding> restored(const PaperModel& paper, std::shared_ptr<const FacetGraph> graph,
                           std::span<const PaperVertex> names);

/// The designer's cuts and folds that are still there, for a new search.
EdgeRules wishes_on(const PaperModel& paper, const FacetGraph& graph, std::span<const PaperVertex> names);

/// Names for a mesh that stands for itself: vertex by number.
std::vector<PaperVertex> plain_names(const FacetGraph& graph);

}  // namespace hariko

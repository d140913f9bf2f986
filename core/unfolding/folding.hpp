#pragma once

// Folding a paper model up: where its facets are on the way from flat pages to the solid.

#include <array>
#include <vector>

#include "core/unfolding/unfolding.hpp"

namespace hariko {

using SpaceCorners = std::array<Vector3, 3>;

/// Corners of every facet in mm for t in 0 .. 1 (clamped). At 0 the facets lie in the plane z = 0 with the
/// outside up, page beside page with `page_distance` from one left edge to the next. All folds turn by t of
/// their angle, and the roots of the pieces travel to their places; at 1 the facets are the mesh times the
/// scale, its box standing on z = 0 over the middle of the pages. Lengths of facets are kept at every t.
/// O(facets).
std::vector<SpaceCorners> folded_positions(const Unfolding& unfolding, double t, double page_distance);

}  // namespace hariko

#pragma once

// Folding animation of a paper model: positions of its facets between the flat pages and the solid.

#include <array>
#include <vector>

#include "core/unfolding/unfolding.hpp"

namespace hariko {

/// Corners of a facet in space.
using SpaceCorners = std::array<Vector3, 3>;

/// Corners of every facet, in mm, for t in 0 .. 1 (clamped). At 0 the facets lie in the plane z = 0 with the
/// outside up, the pages side by side with `page_distance` from one left edge to the next. Every fold has t
/// times its angle, and the roots of the pieces move to their final places; at 1 the facets form the mesh
/// times the scale, its box standing on z = 0 over the middle of the pages. Side lengths are preserved at
/// every t. O(facets).
std::vector<SpaceCorners> folded_positions(const Unfolding& unfolding, double t, double page_distance);

}  // namespace hariko

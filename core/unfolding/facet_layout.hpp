#pragma once

// Facets in the plane: their shapes, hinging one to the next, and the layout of pieces from folds.

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vector.hpp"
#include "core/unfolding/facet_graph.hpp"

namespace hariko {

/// The corners of a facet in the plane, counter-clockwise seen from outside, in the mesh's corner order.
using FacetCorners = std::array<Vector2, 3>;

/// Each facet by itself: corner 0 at the origin, corner 1 on the x axis. Lengths times `scale`. O(facets).
std::vector<FacetCorners> facet_shapes(const FacetGraph& graph, double scale);

/// `shape` moved so that its side `side` runs from `a` to `b`. Both are copied bit for bit into the result;
/// the distance between them is that of the side up to rounding. z = m + w (t - t_m), |w| = 1, between the
/// midpoints m of ab and t_m of the side.
FacetCorners hinge(const FacetCorners& shape, Index side, const Vector2& a, const Vector2& b);

/// The neighbour across side `side` of `facet`, which lies at `corners`.
FacetCorners hinge_neighbour(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, Index facet,
                             const FacetCorners& corners, Index side);

/// 1 for every edge that is folded, 0 for every edge that is cut; borders are 0.
using Folds = std::vector<std::uint8_t>;

/// The facets that folds hold together.
struct LaidPiece {
  std::vector<Index> facets;  ///< the root first, then parents before children, breadth first
};

/// Pieces ascend by their lowest facet, which is the root, lying as its shape does.
struct FlatLayout {
  std::vector<LaidPiece> pieces;
  std::vector<Index> piece_of;        ///< per facet
  std::vector<FacetCorners> corners;  ///< per facet, in the frame of its piece
};

/// `folds` must form a forest: no cycles (programmer's error). O(facets).
FlatLayout lay_out(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, const Folds& folds);

}  // namespace hariko

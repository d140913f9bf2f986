#pragma once

// Layout of facets in the plane: their shapes, hinging, and pieces from given folds.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vector.hpp"
#include "core/unfolding/facet_graph.hpp"

namespace hariko {

/// Corners of a facet in the plane, in the mesh's order, counter-clockwise seen from outside.
using FacetCorners = std::array<Vector2, 3>;
/// Longest side of a shape, or of all shapes; zero where there are none.
double longest_side(const FacetCorners& shape);
double longest_side(std::span<const FacetCorners> shapes);

/// Shape of each facet: corner 0 at the origin, corner 1 on the x axis, lengths times `scale`. O(facets).
std::vector<FacetCorners> facet_shapes(const FacetGraph& graph, double scale);

/// Shape moved so that its side `side` runs from `a` to `b`, which are copied bit for bit; their distance
/// must equal the side's length up to rounding. In complex numbers z = m + w (t - t_m), |w| = 1, with the
/// midpoints m of ab and t_m of the side.
FacetCorners hinge(const FacetCorners& shape, Index side, const Vector2& a, const Vector2& b);

/// Position of the neighbour across side `side` of a facet that lies at `corners`.
FacetCorners hinge_neighbour(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, Index facet,
                             const FacetCorners& corners, Index side);

/// Folds of an unfolding: 1 for every folded edge, 0 for cut edges and borders.
using Folds = std::vector<std::uint8_t>;

/// Connected facets in the plane.
struct LaidPiece {
  std::vector<Index> facets;  ///< root first, parents before children, breadth first
};

/// Pieces of an unfolding, ascending by their lowest facet, which is the root and has the position of its
/// shape.
struct FlatLayout {
  std::vector<LaidPiece> pieces;
  std::vector<Index> piece_of;        ///< by facet
  std::vector<FacetCorners> corners;  ///< by facet, in the frame of its piece
};

/// Lays out the pieces for given folds, which must form a forest (asserted: no cycles). O(facets).
FlatLayout lay_out(const FacetGraph& graph, const std::vector<FacetCorners>& shapes, const Folds& folds);

}  // namespace hariko

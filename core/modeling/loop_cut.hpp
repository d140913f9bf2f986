#pragma once

// Loop cut: new edges across a ring of quads.

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"
#include "core/modeling/surface_form.hpp"

namespace hariko {

struct LoopCutOptions {
  int count = 1;  ///< cuts side by side, 1 .. 1000
  double slide =
      0;  ///< -1 .. 1 (both excluded): moves the cuts, evenly spread at 0, towards an end of the edges
};

inline constexpr int max_cuts = 1000;

/// Where the cuts lie, as shares of the edges' lengths: (i + slide) / (count + 1), i = 1 .. count.
std::vector<double> cut_shares(const LoopCutOptions& options);

/// Cuts every quad of the edge's ring (`edge_ring`) from edge to edge. At the ends of an open ring the new
/// points become corners of the faces there. A quad that the ring crosses in both directions becomes a grid.
/// The slide counts from the end with the smaller id of the given edge.
///
/// New points have the tension in between that of the ends of their edge; pieces of edges keep tension and
/// crease. A new edge between two edges of the same tension has that tension; none is a crease. Cuts near an
/// end are short at one side: `tighten_short_edges`. Given `on`, the form of `source`, the cuts lie on the
/// surface, which stays; then no tension is added. Cut faces pass their id to one of their parts. The Euler
/// number stays. Selected afterwards: the new edges.
///
/// Errors: E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (count or slide out of range), E_WRONG_SELECTION (no quad at the
/// edge), E_TOO_MANY_ELEMENTS, E_WOULD_BE_NONMANIFOLD (two quads lying back to back).
Result<Modeled> loop_cut(const PolyhedronSource& source, EdgeId edge, const LoopCutOptions& options = {},
                         const SurfaceForm* on = nullptr);

}  // namespace hariko

#pragma once

// Loop cut: new edges across a ring of quads.

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/surface_form.hpp"

namespace hariko {

struct LoopCutOptions {
  int count = 1;  ///< number of parallel cuts, 1 .. 1000
  /// Shift of the cuts towards an end of the edges, -1 .. 1 (both excluded); at 0 they are evenly spread.
  double slide = 0;
};

inline constexpr int max_cuts = 1000;

/// Fractions of the edges' lengths at which the cuts lie: (i + slide) / (count + 1), i = 1 .. count.
std::vector<double> cut_shares(const LoopCutOptions& options);

/// Cuts every quad of the edge's ring (`edge_ring`) from edge to edge. At the ends of an open ring the new
/// points become corners of the faces there. A quad that the ring crosses in both directions becomes a grid.
/// The slide counts from the end with the smaller id of the given edge.
///
/// New points have the tension interpolated between those of the ends of their edge; pieces of edges keep
/// tension and crease. A new edge between two edges of the same tension has that tension; none is a crease.
/// Cuts near an end leave short edges on one side: `tighten_short_edges`. Given `on`, the form of `source`,
/// the cuts lie on the surface, which stays unchanged; then no tension is added. Cut faces pass their id to
/// one of their parts. The Euler number stays. Selected afterwards: the new edges.
///
/// Errors: E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (count or slide out of range), E_WRONG_SELECTION (no quad at the
/// edge), E_TOO_MANY_ELEMENTS, E_WOULD_BE_NONMANIFOLD (two quads lying back to back).
Result<EditResult> loop_cut(const PolyhedronSource& source, EdgeId edge, const LoopCutOptions& options = {},
                            const SurfaceForm* on = nullptr);

}  // namespace hariko

#pragma once

// Bevelling edges: each becomes a flat band (a chamfer).

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Replaces edges by bands whose sides lie `width` from the old edge in its two faces. Where several of the
/// edges meet, their bands share corners and leave a face between them (none where two meet). Round such a
/// vertex, other edges that lie alone between two bands, or at an open border, guide the corner, so that the
/// faces beside them stay planar; there the width of bands at unequal angles is the mean of what they ask
/// for. Where a band ends, the edges next to it are cut; at a vertex of more than three edges a triangle
/// leads to the vertex, at an inner vertex of two edges the band runs into a point. Open edges among the
/// given ones have no second face and are left as they are. The Euler number stays.
///
/// Planar faces stay in their planes but where, at a vertex, two or more edges that are not bevelled lie side
/// by side between two bands, or one or more between a band and an open border: one corner stands for the
/// vertex in all faces of that sector, whose planes need not have another common point. It lies in the mean
/// direction of the two bands, or on the border, and the faces tilt, the more the coarser and the less convex
/// the corner is. Bevelling those edges too avoids it.
///
/// Both sides of a band have the edge's tension and crease; the ends of bands are plain
/// (`tighten_short_edges` for narrow ones), but a crease that goes on beyond the end of a band carries on
/// round the end face. New vertices have the tension and tag of the one they replace, whose pin is gone.
/// Selected afterwards: the bands and the faces between them.
///
/// Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_BAD_AMOUNT (not above zero, or so wide that an edge would
/// shrink to nothing), E_WRONG_SELECTION (only open edges; an edge whose band would be a point at both ends).
Result<EditResult> bevel_edges(const PolyhedronSource& source, std::span<const EdgeId> edges, double width);

/// Returns the smallest width that `bevel_edges` refuses; it refuses all larger ones too. Errors: those of
/// `bevel_edges` that concern the selection.
Result<double> largest_edge_bevel(const PolyhedronSource& source, std::span<const EdgeId> edges);

}  // namespace hariko

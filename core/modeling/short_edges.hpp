#pragma once

// Tension for new edges that are much shorter than their neighbours.

#include "core/document/source.hpp"

namespace hariko {

/// Gives edges that `before` does not have, and that have no tension yet, one that keeps their curves from
/// looping: tangents at a vertex are shared by its edges, so that the short side of a narrow band would get
/// those of its long neighbours (W_LONG_TANGENT). Where the longest edge at an end is more than twice as
/// long, beta becomes the square of that ratio, 1000 at most: the tangent is then about as long as the edge.
/// O(n log n).
void tighten_short_edges(PolyhedronSource& after, const PolyhedronSource& before);

}  // namespace hariko

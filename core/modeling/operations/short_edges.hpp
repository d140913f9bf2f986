#pragma once

// Tension for new edges that are much shorter than their neighbours.

#include "core/document/source.hpp"

namespace hariko {

/// Gives tension to edges that `before` does not have and that have none yet, so that their curves do not
/// loop: edges at a vertex share its tangents, so that the short side of a narrow band would get the long
/// tangents of its neighbours (W_LONG_TANGENT). Where the longest edge at an end is more than twice as long,
/// beta becomes the square of that ratio, at most 1000: the tangent is then about as long as the edge. O(n
/// log n).
void tighten_short_edges(PolyhedronSource& after, const PolyhedronSource& before);

}  // namespace hariko

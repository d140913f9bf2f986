#pragma once

// Automatic tension: short edges get more tension than long ones, so that a long edge beside them does not
// push their tangents sideways (kuriyama.md section 7).

#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Returns `shaping` with the tension of every edge multiplied by (mean length / its length)^exponent, within
/// the limits of edge tension. Edges of zero length get the upper limit. Depends only on ratios of lengths,
/// so the result is the same at any scale. exponent 0 .. 1; 0 changes nothing. O(edges log edges).
Shaping with_automatic_tension(const Polyhedron& polyhedron, const Shaping& shaping, double exponent);

}  // namespace hariko

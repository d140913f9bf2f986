#pragma once

// Faces that are not quads become stars of quads (Ogasawara and Kobori, section 4; docs/envelope.md).

#include <array>
#include <span>
#include <vector>

#include "core/envelope/network/curve_network.hpp"

namespace hariko {

/// `loop`: the sides, each with the face to its left. `solid`: whose primitive part the face is, or null.
FaceSplit split_face(std::span<const RibbonCurve> loop, const NetworkSolid* solid);

/// Loops of the quads, one a side: from its start to its middle, to the centre, to the middle of the side
/// before, back.
std::vector<std::array<RibbonCurve, 4>> split_loops(std::span<const RibbonCurve> loop,
                                                    const FaceSplit& split);

}  // namespace hariko

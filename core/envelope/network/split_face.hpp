#pragma once

// Division of faces that are not quads into stars of quads (Ogasawara and Kobori, section 4;
// docs/envelope.md).

#include <array>
#include <span>
#include <vector>

#include "core/envelope/network/curve_network.hpp"

namespace hariko {

/// Makes the star of a face. `loop`: the sides, each with the face to its left. `solid`: the solid whose
/// primitive part the face is, or null.
FaceSplit split_face(std::span<const RibbonCurve> loop, const NetworkSolid* solid);

/// Loops of the quads, one per side: from its start to its midpoint, to the centre, to the midpoint of the
/// previous side, and back.
std::vector<std::array<RibbonCurve, 4>> split_loops(std::span<const RibbonCurve> loop,
                                                    const FaceSplit& split);

}  // namespace hariko

#pragma once

// Controls of faces and tangents of the network from a solution of mode G2 (g2.md sections 2 and 6).

#include <vector>

#include "core/g2/g2_given.hpp"

namespace hariko {

/// Controls of a face: those of its chart, then seven Bezier points of each side's curve. Both faces of an
/// edge get the same bits for its curve.
G2Face face_controls(const G2Layout& layout, const CondensedFace& element, Index face, const G2Given& given,
                     const std::vector<Vector3>& unknowns);

/// Network with the surface's own tangents.
Network surface_network(const G2Layout& layout, const G2Given& given, const std::vector<Vector3>& unknowns);

}  // namespace hariko

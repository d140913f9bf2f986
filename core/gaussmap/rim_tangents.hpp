#pragma once

// Tangents of the curve network along an outline.

#include "core/base/flat_map.hpp"
#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Pins of kind tangents for the vertices of the border, whose pins in `shaping` are normals: the tangent
/// along the border is that of the curve through the loop's points (`LoopCurve`), as long as those of the
/// circular arcs to the neighbours; where a loop lies in a plane and its normals allow it, exactly in that
/// plane, so that a flat rim stays flat. Across the border tangents are those of the network as it is without
/// these pins. Errors: those of `NetworkSystem::assemble`. O(vertices).
Result<FlatMap<VertexId, Pin>> rim_tangents(const Polyhedron& polyhedron, const Shaping& shaping);

}  // namespace hariko

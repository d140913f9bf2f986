#pragma once

// Tangents of the curve network along an outline.

#include "core/base/flat_map.hpp"
#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Returns pins of kind tangents for the vertices of the border, whose pins in `shaping` are normals. The
/// tangent along the border is that of the curve through the loop's points (`LoopCurve`), with the length for
/// circular arcs to the neighbours; where a loop is planar and its normals allow it, exactly in its plane, so
/// that a flat rim stays flat. Tangents across the border are those of the network without these pins.
/// Errors: those of `NetworkSystem::assemble`. O(vertices).
Result<FlatMap<VertexId, Pin>> rim_tangents(const Polyhedron& polyhedron, const Shaping& shaping);

}  // namespace hariko

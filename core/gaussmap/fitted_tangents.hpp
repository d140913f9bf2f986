#pragma once

// Tangents of the curve network over control points whose normals are known.

#include <span>

#include "core/base/flat_map.hpp"
#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Pins of kind tangents for all vertices: near those of the network, but of lengths with which its curves
/// have the surface's normal curvature at both ends of every edge, as nearly as the few basis vectors can
/// (gaussmap.md 4). The second fundamental form at a vertex comes from the neighbours' places and normals.
/// `normals`: unit, one a vertex. `shaping` has pins of kind normal inside and of kind tangents on the
/// border; the first of those, the tangent along the border, stays. Errors: those of
/// `NetworkSystem::assemble`. A few hundred times O(edges).
Result<FlatMap<VertexId, Pin>> fitted_tangents(const Polyhedron& polyhedron, const Shaping& shaping,
                                               std::span<const Vector3> normals);

}  // namespace hariko

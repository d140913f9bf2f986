#pragma once

// Fitting of the curve network's tangents to control points with known normals.

#include <span>

#include "core/base/flat_map.hpp"
#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Returns pins of kind tangents for all vertices: near the network's own, but with lengths that give its
/// curves the surface's normal curvature at both ends of every edge, as far as the few basis vectors can
/// (gaussmap.md 4). The second fundamental form at a vertex comes from the positions and normals of its
/// neighbours. `normals`: unit, one per vertex. `shaping` has pins of kind normal inside and of kind tangents
/// on the border; of the latter the first, the tangent along the border, stays. Errors: those of
/// `NetworkSystem::assemble`. A few hundred times O(edges).
Result<FlatMap<VertexId, Pin>> fitted_tangents(const Polyhedron& polyhedron, const Shaping& shaping,
                                               std::span<const Vector3> normals);

}  // namespace hariko

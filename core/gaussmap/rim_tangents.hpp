#pragma once

// Tangents of the curve network along an outline.

#include <vector>

#include "core/base/flat_map.hpp"
#include "core/base/result.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Tangent along the border at one of its vertices.
struct RimTangent {
  Index vertex = no_index;
  Vector3 direction = Vector3::Zero();  ///< unit vector, towards the next vertex of the border
  double ahead = 0, behind = 0;         ///< lengths of the tangents to the next and to the previous vertex
};

/// Tangents along the border of the curve through the points of each loop (`LoopCurve`), with the lengths for
/// circular arcs to the neighbours; where a loop is planar and its normals allow it, exactly in its plane, so
/// that a flat rim stays flat. `shaping` has pins of kind normal on the border. O(border vertices).
std::vector<RimTangent> rim_directions(const Polyhedron& polyhedron, const Shaping& shaping);

/// Returns pins of kind tangents for the vertices of the border, whose pins in `shaping` are normals. The
/// tangent along the border is that of `rim_directions`, of the mean length. Tangents across the border are
/// those of the network without these pins. Errors: those of `NetworkSystem::assemble`. O(vertices).
Result<FlatMap<VertexId, Pin>> rim_tangents(const Polyhedron& polyhedron, const Shaping& shaping);

/// Returns kept forms for the vertices of the border, whose pins in `shaping` are normals, for metric frames:
/// pinned tangents would keep equal angles there, whatever the faces. The tangent along the border is that of
/// `rim_directions`, for each edge as long as its share of the fan; tangents across the border are those of
/// the network. Errors: those of `NetworkSystem::assemble`. O(edges).
Result<FlatMap<VertexId, KeptForm>> rim_forms(const Polyhedron& polyhedron, const Shaping& shaping);

}  // namespace hariko

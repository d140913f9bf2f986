#pragma once

// Local editing (Kuriyama 1991, section 5): a vertex is moved, or its tangents are turned, while the tangents
// round it stay what they are, so that the surface changes in the faces nearby only.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// The vertex has no tangents of its own that could be fixed (it has no face).
inline constexpr Code e_no_tangents{"E_NO_TANGENTS"};

/// These vertices and all corners of the faces round them, ascending. O(corners of these faces, n log n).
std::vector<VertexId> vertices_around(const Polyhedron& polyhedron, std::span<const VertexId> vertices);

/// Pins the tangents at these vertices as the surface has them: the surface stays as it is to rounding, and
/// from then on what happens elsewhere does not reach them. Tangents that are pinned already stay. Where the
/// vertex has other edges on the way to the surface than the designer sees (in the plane of a live mirror, on
/// a concave face that is cut), only its tangent plane can be fixed. Errors: E_UNKNOWN_ELEMENT,
/// E_NO_TANGENTS, and those of the network. O(edges): the network is solved once.
Result<PolyhedronSource> freeze_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices);

/// Applies a linear map to the tangents pinned at these vertices (in the object's space: the turn or the
/// stretch that the designer gives the tangent plane). Pinned planes are turned with it. Vertices without a
/// pin stay free. `linear` must be invertible (asserted).
PolyhedronSource with_turned_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                      const Matrix3& linear);

}  // namespace hariko

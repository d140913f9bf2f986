#pragma once

// Local editing (Kuriyama 1991, section 5): a vertex is moved, or its tangents are turned, while the tangents
// round it stay unchanged, so that the surface changes in the nearby faces only.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/document/source.hpp"

namespace hariko {

/// Error: the vertex has no tangents of its own that could be fixed (it has no face).
inline constexpr Code e_no_tangents{"E_NO_TANGENTS"};

/// Returns these vertices and all corners of the faces round them, ascending. O(corners of these faces, n log
/// n).
std::vector<VertexId> vertices_around(const Polyhedron& polyhedron, std::span<const VertexId> vertices);

/// Pins the tangents at these vertices as the surface has them: the surface stays as it is to rounding, and
/// later changes elsewhere no longer affect these tangents. Tangents that are pinned already stay. Where the
/// prepared polyhedron has other edges at the vertex than the designer's (in the plane of a live mirror, on a
/// concave face that is cut), only its tangent plane can be fixed. Errors: E_UNKNOWN_ELEMENT, E_NO_TANGENTS,
/// and those of the network. O(edges): the network is solved once.
Result<PolyhedronSource> freeze_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices);

/// Applies a linear map to the tangents pinned at these vertices (in the object's space: the rotation or
/// stretch that the designer gives the tangent plane). Pinned planes are turned with it. Vertices without a
/// pin stay free. `linear` must be invertible (asserted).
PolyhedronSource with_turned_tangents(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                      const Matrix3& linear);

}  // namespace hariko

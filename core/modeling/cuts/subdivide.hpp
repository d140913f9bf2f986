#pragma once

// Subdividing edges by new vertices, and faces round a new vertex.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/surface_form.hpp"

namespace hariko {

// All functions: given `on`, the form of `source`, new vertices lie on the surface, which stays unchanged.

/// Puts `count` (1 .. 1000) evenly spaced vertices on each edge. They get tensions interpolated between those
/// of its ends, the pieces keep tension and crease; on an open edge the border stays smooth there. The Euler
/// number stays. Selected afterwards: the new vertices. Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT,
/// E_BAD_AMOUNT, E_TOO_MANY_ELEMENTS.
Result<EditResult> subdivide_edges(const PolyhedronSource& source, std::span<const EdgeId> edges,
                                   int count = 1, const SurfaceForm* on = nullptr);

/// Divides each face into quads round its centre (`star_centre`) by the midpoints of its sides, which also
/// become corners of the neighbouring faces. New vertices lie on the faces, so that the shape of the
/// polyhedron stays. Pieces of sides keep tension and crease, the inner edges are plain. One part keeps the
/// face's id. The Euler number stays. Selected afterwards: all parts. Errors: E_NOTHING_SELECTED,
/// E_UNKNOWN_ELEMENT, E_NO_CENTRE.
Result<EditResult> subdivide_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                                   const SurfaceForm* on = nullptr);

/// Puts a vertex at the centre of each face (`star_centre`) and divides the face into triangles round it. The
/// new edges are plain; one part keeps the face's id. The Euler number stays. Selected afterwards: the new
/// vertices. Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_NO_CENTRE.
Result<EditResult> poke_faces(const PolyhedronSource& source, std::span<const FaceId> faces,
                              const SurfaceForm* on = nullptr);

}  // namespace hariko

#pragma once

// Dissolving: removing elements without leaving a hole, by joining the faces round them.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

// Errors of all three functions: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (nothing to join),
// E_FACE_TOO_SMALL (a face would keep fewer than three corners), E_WOULD_BE_NONMANIFOLD (the joined face
// would not be a disk, or two edges would join the same vertices). The joined face keeps the lowest id of its
// parts; the Euler number stays.

/// Joins the faces round each vertex into one; at a vertex of two edges, and at a border, joins these two
/// edges into one. Selects the joined faces.
Result<EditResult> dissolve_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices);

/// Joins the faces on both sides of each edge into one. Vertices left with two edges are removed too where
/// their faces have more than three corners, because they would only bend an edge. Border edges have a face
/// on one side only and are refused. Selects the joined faces.
Result<EditResult> dissolve_edges(const PolyhedronSource& source, std::span<const EdgeId> edges);

/// Joins neighbouring faces of the selection into one. Selects the joined faces.
Result<EditResult> dissolve_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

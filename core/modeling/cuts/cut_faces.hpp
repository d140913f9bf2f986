#pragma once

// Cutting faces by diagonals, without new vertices: into triangles, or concave faces into convex pieces.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Cuts faces into triangles (`triangles_of`). The first triangle keeps the face's id. Selects the triangles.
/// Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (all faces given are triangles),
/// E_WOULD_BE_NONMANIFOLD (every suitable diagonal is an edge already), E_TOO_MANY_ELEMENTS.
Result<EditResult> triangulate_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

/// Cuts concave faces into convex pieces (`convex_pieces`); the new edges have no tension and no crease.
/// Faces that are convex, or whose projection intersects itself, stay. Selects the pieces. Errors as for
/// `triangulate_faces`, but E_WRONG_SELECTION where no face given is concave.
Result<EditResult> decompose_concave_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

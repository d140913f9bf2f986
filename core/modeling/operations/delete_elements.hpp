#pragma once

// Deleting elements of a polyhedron, which leaves a hole.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

// Vertices that lose their last face are deleted too. Nothing is selected afterwards. Errors of all three
// functions: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_NO_FACES (nothing would be left),
// E_WOULD_BE_NONMANIFOLD (parts would touch in one vertex only).

/// Deletes vertices with all faces round them.
Result<EditResult> delete_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices);
/// Deletes edges with the faces on both sides.
Result<EditResult> delete_edges(const PolyhedronSource& source, std::span<const EdgeId> edges);
Result<EditResult> delete_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

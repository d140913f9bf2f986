#pragma once

// Deleting elements of a polyhedron: what is left has a hole there.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

// Vertices that lose their last face go with it. Nothing is selected afterwards. Errors of all:
// E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_NO_FACES (nothing would be left), E_WOULD_BE_NONMANIFOLD (parts
// would hang together in one vertex only).

/// With all faces round them.
Result<Modeled> delete_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices);
/// With the faces on both sides.
Result<Modeled> delete_edges(const PolyhedronSource& source, std::span<const EdgeId> edges);
Result<Modeled> delete_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

#pragma once

// Dissolving: taking elements away without making a hole, the faces round them become one.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

// Errors of all: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (nothing to join), E_FACE_TOO_SMALL
// (a face would keep fewer than three corners), E_WOULD_BE_NONMANIFOLD (the joined face would not be a disk,
// or an edge would come twice). The joined face keeps the lowest id of its parts; the Euler number stays.

/// The faces round each vertex become one; at a vertex of two edges, and at a border, these edges become one.
/// Selects the joined faces.
Result<Modeled> dissolve_vertices(const PolyhedronSource& source, std::span<const VertexId> vertices);

/// The faces on both sides become one. Vertices that keep two edges go as well where their faces have corners
/// to spare: they would only bend an edge. Border edges have a face on one side only and are refused. Selects
/// the joined faces.
Result<Modeled> dissolve_edges(const PolyhedronSource& source, std::span<const EdgeId> edges);

/// Neighbouring faces of the selection become one. Selects the joined faces.
Result<Modeled> dissolve_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

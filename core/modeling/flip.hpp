#pragma once

// Turning faces over.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

/// Faces look the other way; pinned normals turn with them. Only whole parts can: neighbours of one surface
/// must agree. Selects the faces. Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (a face
/// has a neighbour that is not given; names it).
Result<Modeled> flip_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

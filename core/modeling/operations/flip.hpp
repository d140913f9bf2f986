#pragma once

// Reversing the orientation of faces.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Reverses the orientation of faces and of pinned normals. Only whole connected parts can be reversed,
/// because neighbouring faces must agree. Selects the faces. Errors: E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT,
/// E_WRONG_SELECTION (a face has a neighbour that is not given; names it).
Result<EditResult> flip_faces(const PolyhedronSource& source, std::span<const FaceId> faces);

}  // namespace hariko

#pragma once

// Filling holes with faces.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"

namespace hariko {

/// Closes with one face each border that contains one of the edges. Selects the new faces. Errors:
/// E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (an edge is not on a border),
/// E_WOULD_BE_NONMANIFOLD.
Result<EditResult> fill_holes(const PolyhedronSource& source, std::span<const EdgeId> edges);

}  // namespace hariko

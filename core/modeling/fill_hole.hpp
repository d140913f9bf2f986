#pragma once

// Filling holes.

#include <span>

#include "core/base/result.hpp"
#include "core/modeling/modeled.hpp"

namespace hariko {

/// Closes each border that one of the edges lies on by one face. Selects the new faces. Errors:
/// E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (an edge is not on a border),
/// E_WOULD_BE_NONMANIFOLD.
Result<Modeled> fill_holes(const PolyhedronSource& source, std::span<const EdgeId> edges);

}  // namespace hariko

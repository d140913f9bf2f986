#pragma once

// Conversion of selected ids to dense indices, with the errors common to all operations.

#include <span>
#include <vector>

#include "core/base/ids.hpp"
#include "core/base/result.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

/// Returns the dense indices of the elements, ascending, each once. Errors: E_NOTHING_SELECTED when there are
/// none (with `remedy`: what to select), E_UNKNOWN_ELEMENT when the polyhedron lacks one. O(n log n).
Result<std::vector<Index>> selected(const Polyhedron& polyhedron, std::span<const VertexId> ids,
                                    const char* remedy);
Result<std::vector<Index>> selected(const Polyhedron& polyhedron, std::span<const EdgeId> ids,
                                    const char* remedy);
Result<std::vector<Index>> selected(const Polyhedron& polyhedron, std::span<const FaceId> ids,
                                    const char* remedy);

}  // namespace hariko

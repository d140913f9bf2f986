#pragma once

// Vertices of a polyhedron onto a reference, as a scan is.

#include <span>
#include <vector>

#include "core/base/result.hpp"
#include "core/modeling/edit_result.hpp"
#include "core/modeling/surfacing/reference_facets.hpp"

namespace hariko {

/// Vertices that nothing moves to a reference, one flag each: those with pinned tangents, which belong to
/// their place, and the ends of edges that are attached to patches. O(n).
std::vector<char> vertices_that_stay(const PolyhedronSource& source);

/// Returns the given vertices without those that stay, as dense indices, ascending. Errors:
/// E_NOTHING_SELECTED, E_UNKNOWN_ELEMENT, E_WRONG_SELECTION (all of them stay).
Result<std::vector<Index>> vertices_to_move(const PolyhedronSource& source,
                                            std::span<const VertexId> vertices);

/// Moves each vertex, unless it stays, to the nearest point of the reference, which is seen from `source`.
/// The seam of a live mirror stays in its plane. Everything else is as before; selects the vertices that were
/// given. Errors: those of `vertices_to_move`. O(n log facets).
Result<EditResult> project_to_reference(const PolyhedronSource& source, std::span<const VertexId> vertices,
                                        const ReferenceFacets& reference);

}  // namespace hariko

#pragma once

// Objects of other kinds become polyhedra that can be edited.

#include "core/base/cancellation.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// The object as a polyhedron with the same surface: of an outline its control points, with their normals
/// pinned. Vertices 0, 1, 2, ... are the outline's points in their order, then the inserted ones. Name,
/// placement and display stay, the polyhedron is shown. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND (a
/// kind that no polyhedron is made of, or one already), those of `control_points` and `outline_polyhedron`.
Result<Document> convert_to_polyhedron(const Document& document, ObjectId object,
                                       const CancelToken& cancel = {});

}  // namespace hariko

#pragma once

// Objects of other kinds become polyhedra that can be edited.

#include "core/base/cancellation.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// The object as a polyhedron. Of an outline, which keeps its surface, the control points with their normals
/// pinned: vertices 0, 1, 2, ... are the outline's points in their order, then the inserted ones. Of solids
/// the ball's quads or the network's polygons with their normals pinned: the surface goes through the
/// vertices but is the polyhedron's in between. Name, placement and
/// display stay, the polyhedron is shown. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND (a kind that no
/// polyhedron is made of, or one already), those of `control_points` and `outline_polyhedron`, of
/// `EnvelopeSurfacer`.
Result<Document> convert_to_polyhedron(const Document& document, ObjectId object,
                                       const CancelToken& cancel = {});

}  // namespace hariko

#pragma once

// Outlines and solids become polyhedra that can be edited.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// An outline as a polyhedron that keeps its surface: the control points with their normals pinned. Vertices
/// 0, 1, 2, ... are the outline's points in their order, then the inserted ones. Name, placement and display
/// stay, the polyhedron is shown. Errors: E_UNKNOWN_OBJECT, E_LOCKED, E_WRONG_KIND, those of `control_points`
/// and `outline_polyhedron`.
Result<Document> convert_outline(const Document& document, ObjectId object, const CancelToken& cancel = {});

/// A polyhedron made from the surface round solids.
struct SolidsPolyhedron {
  PolyhedronSource source;
  double distance = 0;  ///< largest found from its surface to that of the solids (`farthest_from`)
  double outside = 0;   ///< how far solids were found to stick out of its surface; 0 where none does
};

/// The ball's quads or the network's polygons with the surface's normals pinned, in frames by measure: the
/// surface goes through the vertices but is the polyhedron's in between. Errors: those of `EnvelopeSurfacer`
/// and of the polyhedron's surface, E_CANCELLED.
Result<SolidsPolyhedron> solids_polyhedron(const SolidsSource& source, const CancelToken& cancel = {},
                                           const Progress& progress = {});

}  // namespace hariko

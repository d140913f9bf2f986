#pragma once

// Conversion of outlines and solids into polyhedra that can be edited.

#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"
#include "core/document/document.hpp"

namespace hariko {

/// Converts an outline into a polyhedron with the same surface: its vertices are the control points, whose
/// normals are pinned. Vertices 0, 1, 2, ... are the outline's points in their order, then the inserted ones.
/// Name, placement, display and frames stay; the polyhedron is shown. Errors: E_UNKNOWN_OBJECT, E_LOCKED,
/// E_WRONG_KIND, those of `control_points` and `outline_polyhedron`.
Result<Document> convert_outline(const Document& document, ObjectId object, const CancelToken& cancel = {});

/// Polyhedron made from the envelope surface of solids.
struct SolidsPolyhedron {
  PolyhedronSource source;
  double distance = 0;  ///< largest distance found from its surface to the envelope (`farthest_from`)
  double outside = 0;  ///< largest distance found by which solids stick out of its surface; 0 where none does
};

/// Makes a polyhedron from the quads of a ball envelope or the polygons of a network envelope, with the
/// envelope's normals pinned and with frames by measure: its surface passes through the vertices and differs
/// from the envelope in between. Errors: those of `EnvelopeSurfacer` and of the polyhedron's surface,
/// E_CANCELLED.
Result<SolidsPolyhedron> solids_polyhedron(const SolidsSource& source, const CancelToken& cancel = {},
                                           const Progress& progress = {});

}  // namespace hariko

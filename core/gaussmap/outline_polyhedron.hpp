#pragma once

// Conversion of control points into a polyhedron whose surface passes through the outline with its normals
// (gaussmap.md 4).

#include "core/gaussmap/control_points.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

struct OutlinePolyhedron {
  Polyhedron polyhedron;  ///< positions relative to origin; the ids are the numbers of the control points
  /// For equal frames tangents are pinned, along the outline by `rim_tangents` and inside by
  /// `fitted_tangents`. For metric frames normals are pinned, and kept forms give the outline its tangents
  /// (`rim_forms`). The outline's vertices are smooth.
  Shaping shaping;
  Vector3 origin = Vector3::Zero();
};

/// Makes the polyhedron, for a surface with these frames. Errors: those of `Polyhedron::build`, and for equal
/// frames of `rim_tangents` and `fitted_tangents`, for metric ones of `rim_forms`.
Result<OutlinePolyhedron> outline_polyhedron(const ControlPoints& points, Frames frames = Frames::equal);

}  // namespace hariko

#pragma once

// Conversion of control points into a polyhedron whose surface passes through the outline with its normals
// (gaussmap.md 4).

#include "core/gaussmap/control_points.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

struct OutlinePolyhedron {
  Polyhedron polyhedron;  ///< positions relative to origin; the ids are the numbers of the control points
  /// Tangents are pinned, along the outline by `rim_tangents` and inside by `fitted_tangents`; the outline's
  /// vertices are smooth.
  Shaping shaping;
  Vector3 origin = Vector3::Zero();
};

/// Makes the polyhedron. Errors: those of `Polyhedron::build`, `rim_tangents` and `fitted_tangents`.
Result<OutlinePolyhedron> outline_polyhedron(const ControlPoints& points);

}  // namespace hariko

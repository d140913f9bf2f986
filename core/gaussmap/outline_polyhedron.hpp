#pragma once

// Control points become a polyhedron whose surface runs through the outline with its normals
// (gaussmap.md 4.7).

#include "core/gaussmap/control_points.hpp"
#include "core/network/shaping.hpp"
#include "core/polyhedron/polyhedron.hpp"

namespace hariko {

struct OutlinePolyhedron {
  Polyhedron polyhedron;  ///< positions relative to origin; the ids are the numbers of the control points
  /// Normals are pinned inside; on the outline, whose vertices are smooth, tangents are (`rim_tangents`).
  Shaping shaping;
  Vector3 origin = Vector3::Zero();
};

/// Errors: those of `Polyhedron::build` and `rim_tangents`. O(points).
Result<OutlinePolyhedron> outline_polyhedron(const ControlPoints& points);

}  // namespace hariko

#pragma once

// Triangulation of faces, joined at common edges. Private to this folder.

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Triangles of a shape.
struct Triangulated {
  PolygonMesh mesh;
  std::size_t failed = 0;  ///< faces without triangles
};

/// Triangulates all faces of a shape with chordal deviation `tolerance` (mm) and angular deviation `angle`
/// (radians), oriented as the faces. Triangles that joining corners makes degenerate are left out.
Triangulated triangulated(const TopoDS_Shape& shape, double tolerance, double angle,
                          const Message_ProgressRange& range);

}  // namespace hariko

#pragma once

// Triangulation of faces, joined at common edges. Private to this folder.

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>
#include <span>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

/// Triangles of a shape.
struct Triangulated {
  PolygonMesh mesh;
  std::size_t failed = 0;  ///< faces without triangles
};

/// Triangulates all faces of a shape with chordal deviation `tolerance` (mm; 1e-7 where it is less, the least
/// that the kernel knows) and angular deviation `angle` (radians), oriented as the faces. `bodies` has a
/// number for each face: points are joined within a body, and bodies that touch stay apart. Triangles that
/// joining corners makes degenerate are left out.
Triangulated triangulated(const TopoDS_Shape& shape, std::span<const Index> bodies, double tolerance,
                          double angle, const Message_ProgressRange& range);

}  // namespace hariko

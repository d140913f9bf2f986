#pragma once

// Faces as triangles that are joined at common edges. Only for this folder.

#include <Message_ProgressRange.hxx>
#include <TopoDS_Shape.hxx>

#include "core/polyhedron/polygon_mesh.hpp"

namespace hariko {

struct Triangulated {
  PolygonMesh mesh;
  std::size_t failed = 0;  ///< faces without triangles
};

/// Triangles of all faces of a shape, no farther than `tolerance` (mm) from them and with the faces' outside.
/// Triangles without area between joined corners are left out.
Triangulated triangulated(const TopoDS_Shape& shape, double tolerance, double angle,
                          const Message_ProgressRange& range);

}  // namespace hariko

#pragma once

// Conversion of reference facets to triangles, and to a surface of flat patches.

#include "core/document/document.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// Triangles in the object's space, without normals; polygons are triangulated.
TriangleMesh triangles_of(const MeshSource& source);

/// Flat patches in the object's space; their provenance is the faces.
Surface facets_of(const MeshSource& source);

}  // namespace hariko

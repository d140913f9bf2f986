#pragma once

// Reference facets as what surfaces are: triangles, and a surface of flat patches.

#include "core/document/document.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

/// In the object's space, without normals: polygons are cut into triangles.
TriangleMesh triangles_of(const MeshSource& source);

/// Flat patches, in the object's space, whose provenance are the faces.
Surface facets_of(const MeshSource& source);

}  // namespace hariko

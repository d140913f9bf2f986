#pragma once

// The coarse mesh over a surface from which refinement starts.

#include "core/approximation/parameter_mesh.hpp"

namespace hariko {

/// Two facets a square (cut along the shorter diagonal), one a triangle, welded along seams: sides of
/// T-joints are cut where their neighbours' sides end, and all patches are cut into 2 x 2 or 3 x 3 where
/// facets would have two equal corners otherwise (closed sides). A side that is shrunk to a point gives pole
/// corners. O(patches + seams).
ParameterMesh initial_mesh(const Surface& surface);

/// Every patch as columns x rows cells of two facets each; for squares only.
ParameterMesh grid_mesh(const Surface& surface, int columns, int rows);

}  // namespace hariko

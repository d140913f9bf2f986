#pragma once

// Triangles of a surface for rays and distances: every patch on the same grid, without numbers in common.
// `tessellate` welds them.

#include <array>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Points of all patches, and the triangles between them.
struct SurfaceTriangles {
  std::vector<Vector3> positions;               ///< relative to the surface's origin
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise seen from outside
};

/// Triangles with density >= 1 intervals a patch side, those of a patch one after the other, in the order of
/// GridPattern. The same on any number of threads. O(patches * density^2), in parallel.
SurfaceTriangles surface_triangles(const Surface& surface, int density);

/// Whether a surface has no border. Sides that are shrunk to a point are none; patches without any seam, such
/// as facets, meet in the sides between the same two nodes. False without patches. O(patches log patches).
bool is_closed(const Surface& surface);

}  // namespace hariko

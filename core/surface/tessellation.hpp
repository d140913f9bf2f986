#pragma once

// Uniform tessellation of a surface: every patch on the same grid, welded, without cracks.

#include <array>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/base/vector.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Triangle mesh with shared positions and separately shared normals (they differ across creases). Positions
/// are relative to `origin`. `normals` and `normal_triangles` are empty for meshes without normals.
struct TriangleMesh {
  Vector3 origin = Vector3::Zero();
  std::vector<Vector3> positions;
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<Vector3> normals;                 ///< unit normals
  std::vector<std::array<Index, 3>> normal_triangles;
};

/// Tessellates with density >= 1 intervals per patch side. Points on seams and at nodes are shared, so the
/// mesh has no cracks: an edge inside is used exactly twice, in opposite directions. Normals are the
/// surface's own; they are shared across G1 and G2 seams and split across G0 ones. O(patches * density^2).
TriangleMesh tessellate(const Surface& surface, int density, const CancelToken& cancel = {});

}  // namespace hariko

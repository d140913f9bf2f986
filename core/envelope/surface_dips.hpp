#pragma once

// Places where a surface runs below the surfaces of solids.

#include <span>
#include <vector>

#include "core/base/cancellation.hpp"
#include "core/envelope/placed_solid.hpp"
#include "core/surface/tessellation.hpp"

namespace hariko {

struct SurfaceDip {
  Index patch, solid;
  Vector3 point, normal;  ///< of the surface
  double depth;           ///< along the normal to the solid's surface, length
};

/// Of every patch and solid the places that are deeper than what is round them, by more than `least` (a
/// length) each. They are looked for at the vertices of `mesh`, which is `tessellate(surface, density)`,
/// density >= 4, and between these at the summits of the depths. In the order of patches. O(patches *
/// (density^2 * solids nearby)).
std::vector<SurfaceDip> surface_dips(const Surface& surface, const TriangleMesh& mesh, int density,
                                     std::span<const PlacedSolid> solids, double least,
                                     const CancelToken& cancel = {});

}  // namespace hariko

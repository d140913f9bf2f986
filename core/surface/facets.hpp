#pragma once

// Facet surfaces: flat triangles as a Surface, so that reference meshes can be used wherever surfaces are.

#include <array>
#include <span>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// Surface with one flat patch for each triangle of positions relative to `origin`. It has no seams and no
/// boundary sides: each facet has its own normal. `sources` are the elements of the triangles, one each.
/// O(triangles).
Surface facet_surface(const Vector3& origin, std::span<const Vector3> positions,
                      std::vector<std::array<Index, 3>> triangles, std::span<const Element> sources);

}  // namespace hariko

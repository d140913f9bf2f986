#pragma once

// Facets as a surface: flat triangles, so that reference meshes go where surfaces go.

#include <array>
#include <span>
#include <vector>

#include "core/surface/surface.hpp"

namespace hariko {

/// One flat patch for each triangle of positions relative to `origin`. Without seams and boundary sides: each
/// facet has its own normal. `sources` are the elements of the triangles, one each. O(triangles).
Surface facet_surface(const Vector3& origin, std::span<const Vector3> positions,
                      std::vector<std::array<Index, 3>> triangles, std::span<const Element> sources);

}  // namespace hariko

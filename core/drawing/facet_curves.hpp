#pragma once

// Drawn lines of meshes of flat facets.

#include <vector>

#include "core/drawing/space_curves.hpp"

namespace hariko {

/// Whether the surface is a mesh of flat triangles with their own normals (`facet_surface`), not patches with
/// seams.
bool is_facets(const Surface& surface);

/// Borders; creases, which are edges sharper than 30 degrees or with more than two facets; and silhouettes,
/// which are edges between a facet that faces the viewer and one that does not. Consecutive edges of one kind
/// are joined to one curve. O(edges log edges).
std::vector<SpaceCurve> facet_curves(const SurfaceGrid& grid, const DrawingView& view);

}  // namespace hariko

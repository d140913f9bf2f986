#pragma once

// The lines of a mesh of flat facets in a drawing.

#include <vector>

#include "core/drawing/space_curves.hpp"

namespace hariko {

/// Flat triangles with normals of their own (`facet_surface`), not patches with seams.
bool is_facets(const Surface& surface);

/// Borders, edges that are sharper than 30 degrees or have more than two facets as creases, and edges between
/// a facet that is turned to the viewer and one that is not as silhouettes. Edges of a kind that follow each
/// other are one curve.
std::vector<SpaceCurve> facet_curves(const SurfaceGrid& grid, const DrawingView& view);

}  // namespace hariko

#pragma once

// Computation of the values of surface maps.

#include "render/color_map.hpp"
#include "render/display_mesh.hpp"

namespace hariko {

/// Options for DisplayMesh::build that give a mesh the values of `map`: curvatures at the points, the
/// relative jump of the curvature tensor (0 .. 2) on the seams for `continuity`, nothing for maps without
/// values.
DisplayOptions map_options(SurfaceMap map, int density);

/// Values of the mesh for the map, as automatic_range and histograms need them. O(values).
std::vector<float> values_of(const DisplayMesh& mesh, SurfaceMap map);

}  // namespace hariko

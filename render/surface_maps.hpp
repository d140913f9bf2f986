#pragma once

// From the name of a map to the functions that compute its values.

#include "render/color_map.hpp"
#include "render/display_mesh.hpp"

namespace hariko {

/// Options for DisplayMesh::build so that the mesh carries what `map` needs: curvatures on the points, the
/// relative jump of the curvature tensor (0 .. 2) on the seams for `continuity`, nothing for maps without
/// values.
DisplayOptions map_options(SurfaceMap map, int density);

/// The mesh's values for the map: what automatic_range and histograms take. O(values).
std::vector<float> values_of(const DisplayMesh& mesh, SurfaceMap map);

}  // namespace hariko

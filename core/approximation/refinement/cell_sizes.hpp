#pragma once

// Start mesh: the mesh from which refinement starts, by the options.

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Makes the start mesh. For `MeshStart::cells` the number of cells along each side comes from a few samples
/// of the curvature across it; sides joined by seams have the same number. Triangular patches, and criteria
/// without a distance or an angle, start with whole patches. O(patches + facets).
ParameterMesh start_mesh(const SurfaceSampler& sampler, const MeshOptions& options);

}  // namespace hariko

#pragma once

// The mesh from which refinement starts, as the options want it.

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// For `MeshStart::cells` the number of cells along each side comes from a few samples of the curvature
/// across it; sides that seams join have the same. Triangular patches, and criteria without a distance or an
/// angle, start with whole patches. O(patches + facets).
ParameterMesh start_mesh(const SurfaceSampler& sampler, const MeshOptions& options);

}  // namespace hariko

#pragma once

// Mesh optimisation: fewer facets under the same tolerances, by removing vertices, flipping edges and moving
// vertices along the surface.

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// Optimised mesh that satisfies the criteria with as few facets as local search finds; all vertices lie on
/// the surface. Starts from the refinement under half of the tolerances and, for a single square patch, also
/// from the best uniform grid, and takes the smallest result, which may be the plain refinement, as vertices
/// next to poles and where more than two patches meet stay. Nothing is changed where cancelled. Many times
/// slower than refinement; O(facets log facets) per round.
ParameterMesh optimised_mesh(const SurfaceSampler& sampler, const MeshOptions& options,
                             const CancelToken& cancel, const Progress& progress);

}  // namespace hariko

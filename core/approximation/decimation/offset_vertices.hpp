#pragma once

// Balanced meshes: vertices off the surface, so that the surface passes through the mesh instead of bulging
// over it.

#include <optional>

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// Convexity test: true where the Gaussian curvature is positive at a grid on every patch, and all patches
/// bend to the same side.
bool bends_one_way(const SurfaceSampler& sampler);

/// Balanced mesh: the optimised mesh for 1.35 to 1.78 times the distance, with its vertices moved along the
/// normals so that the largest distance, borders included, is as small as possible; facets that are still
/// above the tolerance are cut. Of several factors the smallest result that keeps the tolerance is taken: by
/// certain bounds of the surface against the facets where there are any, and by samples of the facets against
/// the surface. Nothing where distance is not the only criterion, the surface does not bend to one side, no
/// factor succeeds, or it was cancelled. Takes as long as a few optimised meshes.
std::optional<ParameterMesh> balanced_mesh(const SurfaceSampler& sampler, const MeshOptions& options,
                                           const CancelToken& cancel, const Progress& progress);

}  // namespace hariko

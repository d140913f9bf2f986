#pragma once

// Vertices off the surface: a mesh through which the surface passes, instead of one that it bulges over.

#include <optional>

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// True where the Gaussian curvature is positive at a grid on every patch, and all of them bend to the same
/// side.
bool bends_one_way(const SurfaceSampler& sampler);

/// The optimised mesh for up to 1.9 times the distance, its vertices moved along the normals so that the
/// largest distance, borders included, is as small as can be; facets that are above the tolerance then are
/// cut. Of several factors the smallest result that keeps the tolerance: certain bounds of the surface
/// against the facets where there are any, samples of the facets against the surface. Nothing where distance
/// is not the only criterion, the surface does not bend one way, no factor does, or it was cancelled. Takes
/// as long as a few optimised meshes.
std::optional<ParameterMesh> balanced_mesh(const SurfaceSampler& sampler, const MeshOptions& options,
                                           const CancelToken& cancel, const Progress& progress);

}  // namespace hariko

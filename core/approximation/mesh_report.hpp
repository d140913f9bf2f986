#pragma once

// Mesh report: a finished parameter mesh as a result, with triangles, normals and measured errors.

#include "core/approximation/approximate.hpp"
#include "core/approximation/refinement/bisection.hpp"
#include "core/approximation/refinement/facet_error.hpp"

namespace hariko {

/// Converts a parameter mesh: drops facets without area at poles, shares normals that agree to 1e-3 radians,
/// and measures the errors that `options` require, reusing those known from the refinement. `unreached` and
/// warnings are left to the caller. Nothing is set where cancelled.
MeshApproximation mesh_report(const SurfaceSampler& sampler, const FacetErrors& errors,
                              const MeshOptions& options, const ParameterMesh& mesh,
                              const BisectionResult& refined = {}, const CancelToken& cancel = {},
                              const Progress& progress = {});

}  // namespace hariko

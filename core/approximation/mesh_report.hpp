#pragma once

// A finished parameter mesh as a result: triangles with normals, and its measured errors.

#include "core/approximation/approximate.hpp"
#include "core/approximation/bisection.hpp"
#include "core/approximation/facet_error.hpp"

namespace hariko {

/// Drops facets without area at poles, shares normals that agree to 1e-3 radians, measures what `options` ask
/// for. `unreached` and warnings are left to the caller. Nothing is set where cancelled.
/// What the refinement found out about the facets need not be measured again.
MeshApproximation mesh_report(const SurfaceSampler& sampler, const FacetErrors& errors,
                              const MeshOptions& options, const ParameterMesh& mesh,
                              const BisectionResult& refined = {}, const CancelToken& cancel = {},
                              const Progress& progress = {});

}  // namespace hariko

#pragma once

// A finished parameter mesh as a result: triangles with normals, and its measured errors.

#include "core/approximation/approximate.hpp"
#include "core/approximation/facet_error.hpp"

namespace hariko {

/// Drops facets without area at poles, shares normals that agree to 1e-3 radians, measures what `options` ask
/// for. `unreached` and warnings are left to the caller. Nothing is set where cancelled.
MeshApproximation mesh_report(const SurfaceSampler& sampler, const FacetErrors& errors,
                              const MeshOptions& options, const ParameterMesh& mesh,
                              const CancelToken& cancel = {}, const Progress& progress = {});

/// The largest distance alone, looked for with care where it matters; per facet values by a first pass.
CriterionErrors measure_distance(const FacetErrors& errors, const ParameterMesh& mesh, double tolerance);

}  // namespace hariko

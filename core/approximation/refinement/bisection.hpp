#pragma once

// Refinement by bisecting facets until all errors are within their tolerances.

#include <memory>

#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/facet_error.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/base/cancellation.hpp"
#include "core/base/progress.hpp"

namespace hariko {

/// Outcome of a refinement, with data that its report can reuse.
struct BisectionResult {
  /// Facets above the tolerance that were left because their edges are shorter than 2e-4 of their patch.
  std::size_t unreached = 0;
  bool limit_reached = false, cancelled = false;
  /// Nets of the final facets; some may have none. Bounds only where distance is a criterion.
  std::shared_ptr<const FacetNets> nets;
  std::vector<double> distance_bounds;
  /// Result of `FacetErrors::net_sampled` for facets whose nets were released, below 0 for those that never
  /// had a net; empty where all nets were kept.
  std::vector<float> sampled_distances;
};

/// Refines the mesh in place, facets with the largest errors first (Yamamoto and Saitoh, sections 2 and 4).
/// The result does not depend on the number of threads. O(n log n) for n facets.
BisectionResult bisect(const SurfaceSampler& sampler, const FacetErrors& errors, const MeshOptions& options,
                       ParameterMesh& mesh, const CancelToken& cancel = {}, const Progress& progress = {});

}  // namespace hariko

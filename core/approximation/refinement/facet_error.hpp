#pragma once

// Errors of one facet against the part of the surface that it approximates.

#include <optional>

#include "core/approximation/luminance.hpp"
#include "core/approximation/mesh_options.hpp"
#include "core/approximation/refinement/facet_control_nets.hpp"
#include "core/approximation/refinement/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// Distance of the surface from a facet. `bound` is certain where `certified`; otherwise it equals `sampled`,
/// which is slightly below the true value (about 0.1 %).
struct DistanceError {
  double sampled = 0, bound = 0;
  bool certified = false;
};

/// Error measures of facets. Keeps references to sampler and criteria. Thread-safe; no call allocates.
class FacetErrors {
 public:
  FacetErrors(const SurfaceSampler& sampler, const MeshCriteria& criteria);

  /// Distance of the surface's part to the closed facet, and of the curve over each side that is a border to
  /// that side, without which the facet could protrude. Refined as far as needed to decide whether it is
  /// within `tolerance`; where it is not, or nothing is certain, `bound` may be above the tolerance.
  DistanceError distance(const ParameterMesh& mesh, Index facet, double tolerance) const;
  /// Best estimate of the distance: a grid of 8 intervals per side, then twice a finer one around the worst
  /// point; and the certain bound, three levels deep, where there is one.
  DistanceError measured_distance(const ParameterMesh& mesh, Index facet) const;

  /// Largest angle between the surface's normals, at a grid of 6 intervals per side, and the facet's,
  /// radians; pi for a facet without area.
  double normal_angle(const ParameterMesh& mesh, Index facet) const;
  /// Largest angle between the normals at corners and midpoints of sides, and the facet's.
  double normal_spread(const ParameterMesh& mesh, Index facet) const;
  /// Largest difference of luminance, at a grid of 6 intervals per side.
  double luminance(const ParameterMesh& mesh, Index facet) const;

  /// Distances from the facet's net, which is faster: a bound as in `distance`, the largest at twelve points,
  /// and an estimate as in `measured_distance`.
  double net_bound(const ParameterMesh& mesh, Index facet, const FacetNet& net, double tolerance) const;
  double net_sampled(const ParameterMesh& mesh, Index facet, const FacetNet& net) const;
  DistanceError net_measured(const ParameterMesh& mesh, Index facet, const FacetNet& net) const;

  /// Largest error relative to its tolerance, over all criteria except the fold angle; at most 1 is good. A
  /// facet that would be good counts as 2 where the surface at a corner is oriented against it. Distances are
  /// bounded by the facet's net where it has one. `distance_bound` gets the bound of the distance.
  double relative_error(const ParameterMesh& mesh, Index facet, const FacetNet& net = {},
                        double* distance_bound = nullptr) const;

  /// Relative error from samples alone and without stopping at the tolerance, for comparing meshes.
  double sampled_error(const ParameterMesh& mesh, Index facet) const;

 private:
  double shape_error(const ParameterMesh& mesh, Index facet) const;
  bool looks_back(const ParameterMesh& mesh, Index facet, const FacetNet& net) const;

  const SurfaceSampler& sampler_;
  const MeshCriteria& criteria_;
  Brightness brightness_;
  friend class DistanceSearch;
};

}  // namespace hariko

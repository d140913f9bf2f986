#pragma once

// The errors of one facet against the part of the surface that it stands for.

#include <optional>

#include "core/approximation/brightness.hpp"
#include "core/approximation/facet_nets.hpp"
#include "core/approximation/mesh_options.hpp"
#include "core/approximation/parameter_mesh.hpp"
#include "core/approximation/surface_sampler.hpp"

namespace hariko {

/// How far a facet is from the surface. `bound` is certain where `certified`; else it repeats `sampled`,
/// which is a little below the truth (about 0.1 %).
struct DistanceError {
  double sampled = 0, bound = 0;
  bool certified = false;
};

/// Borrows sampler and criteria. Thread-safe; no call allocates.
class FacetErrors {
 public:
  FacetErrors(const SurfaceSampler& sampler, const MeshCriteria& criteria);

  /// Distance of the surface's part to the closed facet, and of the curve over each side that is a border to
  /// that side: without it the facet could stick out. Looked into as deep as needed to tell whether it is
  /// within `tolerance`; where it is not, or nothing is certain, `bound` may be above it.
  DistanceError distance(const ParameterMesh& mesh, Index facet, double tolerance) const;
  /// The best estimate: a grid of 8 intervals a side, then twice a finer one round the worst point; and the
  /// bound where it has one, three levels deep.
  DistanceError measured_distance(const ParameterMesh& mesh, Index facet) const;

  /// Largest angle between the surface's normals at a grid of 6 intervals a side and the facet's, radians; pi
  /// for a facet without area.
  double normal_angle(const ParameterMesh& mesh, Index facet) const;
  /// The same at corners and middles of sides only.
  double normal_spread(const ParameterMesh& mesh, Index facet) const;
  /// Largest difference of brightness, at a grid of 6 intervals a side.
  double luminance(const ParameterMesh& mesh, Index facet) const;

  /// The same from the facet's net, faster. The first is as `distance` bounds it, the second the largest of
  /// twelve points, the third as `measured_distance`.
  double net_bound(const ParameterMesh& mesh, Index facet, const FacetNet& net, double tolerance) const;
  double net_sampled(const ParameterMesh& mesh, Index facet, const FacetNet& net) const;
  DistanceError net_measured(const ParameterMesh& mesh, Index facet, const FacetNet& net) const;

  /// Largest error relative to its tolerance, over all criteria but the fold angle; at most 1 is good. A
  /// facet that would be good counts as 2 where the surface at a corner looks the other way. With the facet's
  /// net, where it has one, distances are bounded by that. `distance_bound` gets the bound of the distance.
  double relative_error(const ParameterMesh& mesh, Index facet, const FacetNet& net = {},
                        double* distance_bound = nullptr) const;

  /// The same from samples alone and without stopping at the tolerance, for comparing meshes with each other.
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

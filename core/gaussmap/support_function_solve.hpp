#pragma once

// Support values of inner sites by one sparse linear solve (gaussmap.md 4). Internal to core/gaussmap.

#include "core/base/result.hpp"
#include "core/gaussmap/outlines/boundary_data.hpp"

namespace hariko {

/// Computes support values of all sites, those of the boundary first. `use_curvature`: method 4.2, which
/// draws the sum of the radii of curvature on the boundary towards the value from the given curvature;
/// otherwise method 4.1. Exact for spheres and translations. Error: E_DIVERGED. A sparse factorisation with
/// one row per inner site.
Result<std::vector<double>> linear_fill(const SphereMesh& mesh, const BoundaryData& boundary,
                                        bool use_curvature);

/// Sum of the radii of curvature at a boundary site as used by method 4.2; weight 0 where the boundary runs
/// near an asymptotic direction and the curvature does not determine the sum.
struct RadiusSum {
  double value = 0, weight = 0;
};
/// Sums of the radii of curvature at all boundary sites.
std::vector<RadiusSum> boundary_radius_sums(const SphereMesh& mesh, const BoundaryData& boundary);

}  // namespace hariko

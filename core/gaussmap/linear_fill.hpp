#pragma once

// Support values of inner sites by one sparse linear solve (gaussmap.md 4). Internal to
// core/gaussmap.

#include "core/base/result.hpp"
#include "core/gaussmap/boundary_data.hpp"

namespace hariko {

/// Support values of all sites, those of the boundary first. `use_curvature`: 4.2, the sum of the radii of
/// curvature on the boundary is pulled to what the given curvature says there; otherwise 4.1. Exact for
/// spheres and translations. Error: E_DIVERGED. A sparse factorisation of one row an inner site.
Result<std::vector<double>> linear_fill(const SphereMesh& mesh, const BoundaryData& boundary,
                                        bool use_curvature);

/// What 4.2 takes for the sum of the radii of curvature at the boundary sites; weight 0 where the boundary
/// runs near an asymptotic direction and the curvature says nothing about it.
struct RadiusSum {
  double value = 0, weight = 0;
};
std::vector<RadiusSum> boundary_radius_sums(const SphereMesh& mesh, const BoundaryData& boundary);

}  // namespace hariko

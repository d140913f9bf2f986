#pragma once

// Points and curvature of the surface from the support values of its sites (gaussmap.md 4). Internal to
// core/gaussmap.

#include <span>

#include "core/gaussmap/boundary_data.hpp"

namespace hariko {

struct Contact {
  Vector3 point = Vector3::Zero();
  double curvature = 0;  ///< Gaussian, as the support function around has it
};

/// One a site; points of the boundary are the given ones. A weighted least-squares fit around each site:
/// second order, from twelve neighbours on third.
std::vector<Contact> contact_points(const SphereMesh& mesh, const BoundaryData& boundary,
                                    std::span<const double> support);

}  // namespace hariko

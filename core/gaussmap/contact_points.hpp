#pragma once

// Points and curvature of the surface from the support values at its sites (gaussmap.md 4). Internal to
// core/gaussmap.

#include <span>

#include "core/gaussmap/outlines/boundary_data.hpp"

namespace hariko {

/// Point of contact of a tangent plane.
struct Contact {
  Vector3 point = Vector3::Zero();
  double curvature = 0;  ///< Gaussian curvature by the support function nearby
};

/// Contact of each site; boundary sites have the given points. Weighted least-squares fit around each site:
/// second order, with twelve or more neighbours third order.
std::vector<Contact> contact_points(const SphereMesh& mesh, const BoundaryData& boundary,
                                    std::span<const double> support);

}  // namespace hariko

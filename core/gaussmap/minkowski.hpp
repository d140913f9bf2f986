#pragma once

// Discrete Minkowski problem with fixed planes on the boundary: support values for which facets have
// prescribed areas (gaussmap.md 4). Internal to core/gaussmap.

#include "core/gaussmap/control_points.hpp"
#include "core/gaussmap/outlines/boundary_data.hpp"

namespace hariko {

inline constexpr Code e_curvature_incompatible{"E_K_INCOMPATIBLE"};
inline constexpr Code e_curvature_unreachable{"E_K_UNREACHABLE"};
inline constexpr Code w_singular{"W_SINGULAR"};

struct MinkowskiResult {
  std::vector<double> support;
  std::vector<std::array<Index, 3>> triangles;  ///< dual to the polytope's corners, inside the loops
  int iterations = 0;
  double residual = 0;  ///< norm of the relative errors of the areas
  /// The areas do not determine the support (W_SINGULAR): `support` is the start.
  bool singular = false;
};

/// Solves the problem. `start`: support of all sites, from `linear_fill`. `curvature`: at every site,
/// positive. Errors: E_K_UNREACHABLE (the element is the boundary site next to the worst area), E_CANCELLED.
Result<MinkowskiResult> minkowski(const SphereMesh& mesh, const BoundaryData& boundary,
                                  std::vector<double> start, const std::vector<double>& curvature,
                                  CellMeasure measure, const CancelToken& cancel);

/// Extends the boundary's curvature to the inside: the exponential of the harmonic function with the
/// logarithms on the boundary, which is the limit of the paper's averaging.
std::vector<double> spread_curvature(const SphereMesh& mesh, const std::vector<double>& boundary_curvature);

/// Multiplies the curvature by a factor that is linear in the normal, so that the areas can close over the
/// loops: any surface that spans them has the same vector area. Error: E_K_INCOMPATIBLE; the element is the
/// boundary site next to the worst misfit.
Result<std::vector<double>> closing_curvature(const SphereMesh& mesh, const BoundaryData& boundary,
                                              std::vector<double> curvature);

}  // namespace hariko

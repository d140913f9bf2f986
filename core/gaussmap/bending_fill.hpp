#pragma once

// Inner vertices of a mesh with given loops and normals along them, by least bending (gaussmap.md 4).
// Internal to core/gaussmap.

#include "core/base/cancellation.hpp"
#include "core/gaussmap/position_mesh.hpp"

namespace hariko {

inline constexpr Code w_not_settled{"W_NOT_SETTLED"};

/// Normals and curvature of the filled mesh.
struct PositionResult {
  std::vector<Vector3> normals;   ///< at all vertices; the given ones on the boundary
  std::vector<double> curvature;  ///< angle defect divided by area
  int iterations = 0;
  bool settled = true;
};

/// Moves the inner vertices of `mesh`: Gauss-Newton steps with lagged weights on the integral of the squared
/// mean curvature, whose boundary terms clamp the normals. After the first full steps the vertices are
/// distributed evenly over the shape, by `rounds` rounds of `spread_evenly` in total, which also flips edges;
/// vertices in rows stay in them. `normals`: unit, one per boundary vertex. `size`: that of the outline; a
/// step moves no vertex by more than a tenth of it. Errors: E_DIVERGED, E_CANCELLED. One sparse factorisation
/// per step, at most 60.
Result<PositionResult> fill_positions(PositionMesh& mesh, const std::vector<Vector3>& normals, double size,
                                      int rounds, const CancelToken& cancel);

}  // namespace hariko

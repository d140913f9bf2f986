#pragma once

// Inner vertices of a mesh whose loops and normals along them are given: least bending (gaussmap.md 4).
// Internal to core/gaussmap.

#include "core/base/cancellation.hpp"
#include "core/gaussmap/position_mesh.hpp"

namespace hariko {

inline constexpr Code w_not_settled{"W_NOT_SETTLED"};

struct PositionResult {
  std::vector<Vector3> normals;   ///< of all vertices; the given ones on the boundary
  std::vector<double> curvature;  ///< angle defect by area
  int iterations = 0;
  bool settled = true;
};

/// Moves the inner vertices of `mesh`: lagged Gauss-Newton on the integral of the squared mean curvature,
/// whose boundary terms clamp the normals. After the first full steps the vertices are spread evenly over the
/// shape, `rounds` rounds of `spread_evenly` in all, which flips edges too; those in rows stay in them.
/// `normals`: unit, one a boundary vertex. Errors: E_DIVERGED, E_CANCELLED. A sparse factorisation a step, at
/// most 60.
Result<PositionResult> fill_positions(PositionMesh& mesh, const std::vector<Vector3>& normals, double size,
                                      int rounds, const CancelToken& cancel);

}  // namespace hariko

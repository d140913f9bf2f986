#pragma once

// Inner vertices of a mesh whose loops and normals along them are given: least bending (gaussmap.md 4.8).
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
/// whose boundary terms clamp the normals. `normals`: unit, one a boundary vertex. Errors: E_DIVERGED,
/// E_CANCELLED. A sparse factorisation a step, at most 60.
Result<PositionResult> fill_positions(PositionMesh& mesh, const std::vector<Vector3>& normals, double size,
                                      const CancelToken& cancel);

}  // namespace hariko

#pragma once

// JoinFrame: the directions at one end of a joined side.

#include "core/patching/joins/join.hpp"

namespace hariko {

/// Directions at one end of a joined side; all lengths as in the patch's control net.
struct JoinFrame {
  Vector3 tangent = Vector3::Zero();  ///< tangent of the side, leaving the vertex
  Vector3 along = Vector3::Zero();    ///< tangent in the side's own direction: d0 or d2
  Vector3 across = Vector3::Zero();   ///< P(i,1) - P(i,0), into the patch; zero with G0
  Vector3 normal = Vector3::Zero();   ///< Unit outward normal of the tangent plane; zero where there is none.
};
/// Directions at the origin or at the target of a join's half-edge.
JoinFrame join_frame(const Join& join, bool at_origin);

}  // namespace hariko

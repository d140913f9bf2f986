#pragma once

// JoinFrame: the directions at one end of a joined side.

#include "core/patching/join.hpp"

namespace hariko {

struct JoinFrame {
  Vector3 tangent = Vector3::Zero();  ///< tangent of the side, leaving the vertex
  Vector3 along = Vector3::Zero();    ///< tangent in the side's own direction: d0 or d2
  Vector3 across = Vector3::Zero();   ///< P(i,1) - P(i,0), into the patch; zero with G0
  Vector3 normal = Vector3::Zero();   ///< Unit outward normal of the tangent plane; zero where there is none.
};
JoinFrame join_frame(const Join& join, bool at_origin);

}  // namespace hariko

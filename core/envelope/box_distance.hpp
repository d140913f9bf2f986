#pragma once

// How far a point is from a box along the axes.

#include "core/base/vector.hpp"

namespace hariko {

/// Square of the distance, 0 inside.
inline double box_square_distance(const Vector3& p, const Vector3& low, const Vector3& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(Vector3::Zero()).squaredNorm();
}

}  // namespace hariko

#pragma once

// Smooth step: a step from 0 to 1 with a continuous slope.

#include <algorithm>

namespace hariko {

/// Cubic step: 0 up to x = 0, 1 from x = 1 on.
inline double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace hariko

#pragma once

// Measures of a whole surface: area, volume, bending.

#include <optional>

#include "core/base/cancellation.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Integral measures of a surface.
struct Measures {
  double area = 0;  ///< length^2
  /// Volume, length^3, by the divergence theorem; nothing unless the surface is closed.
  std::optional<double> volume;
  /// Bending energy: integral of k1^2 + k2^2 over the area, without unit; a sphere has 8 pi.
  double bending = 0;
};

/// Measures a surface by 10 x 10 Gauss points per patch (`gauss_rule`). Area and volume are good to about
/// 1e-6 of their value, bending to about 1e-3 on patches whose curvature depends on the direction at corners.
/// Does not depend on the origin, on the position of the surface, or on the number of threads. Points without
/// a normal do not contribute. All zero when cancelled. O(100 patches).
Measures measure(const Surface& surface, const CancelToken& cancel = {});

}  // namespace hariko

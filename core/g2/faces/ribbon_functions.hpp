#pragma once

// Functions of a ribbon along its side (g2.md section 3), with their derivatives.

#include "core/g2/faces/jet2.hpp"

namespace hariko {

/// Quintic Hermite functions for (value, first, second) at 0, then at 1, and t^3 (1 - t)^3.
void ribbon_quintic(double t, Derivatives (&out)[7]);
/// Cubic Hermite functions, t^2 (1 - t)^2, and the latter times 2t - 1.
void ribbon_cubic(double t, Derivatives (&out)[6]);
/// Linear functions, t (1 - t), and the latter times 2t - 1.
void ribbon_linear(double t, Derivatives (&out)[4]);

}  // namespace hariko

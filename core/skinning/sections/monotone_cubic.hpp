#pragma once

// Monotone piecewise cubics through increasing data (Fritsch and Carlson's slopes, as in PCHIP).

#include <vector>

namespace hariko {

/// Slopes of the interpolant at data points with increasing x (at least two points).
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y);

/// Cubic Hermite interpolation at `at`; beyond the ends the end pieces are extrapolated.
double hermite(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& slope,
               double at);

}  // namespace hariko

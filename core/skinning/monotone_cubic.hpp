#pragma once

// Monotone piecewise cubics through increasing data (Fritsch and Carlson's slopes, as in PCHIP).

#include <vector>

namespace hariko {

/// Slopes at data points with increasing x (at least two).
std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y);

/// Cubic Hermite interpolation; beyond the ends the end pieces go on.
double hermite(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& slope,
               double at);

}  // namespace hariko

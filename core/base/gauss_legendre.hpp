#pragma once

// Gauss-Legendre quadrature.

#include <vector>

namespace hariko {

/// Node and weight of a quadrature rule.
struct GaussPoint {
  double node, weight;
};

/// Gauss-Legendre rule with `count` >= 1 points on [0, 1], exact for polynomials of degree 2 count - 1.
std::vector<GaussPoint> gauss_legendre_unit(int count);

}  // namespace hariko

#pragma once

// Gauss quadrature over patch domains.

#include <vector>

#include "core/base/vector.hpp"
#include "core/surface/patch.hpp"

namespace hariko {

/// Quadrature rule over a parameter domain.
struct DomainRule {
  std::vector<Vector2> points;
  std::vector<double> weights;  ///< their sum is the area of the domain: 1/2 or 1
};
/// Gauss rule of n x n points, n >= 1. Triangle: collapsed at corner 0, s = x (1 - y), t = x y, weight times
/// x.
DomainRule gauss_rule(Domain domain, int n);

}  // namespace hariko

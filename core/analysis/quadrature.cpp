#include "core/analysis/quadrature.hpp"

#include "core/base/gauss_legendre.hpp"

namespace hariko {

DomainRule gauss_rule(Domain domain, int n) {
  const bool triangle = domain == Domain::triangle;
  const std::vector<GaussPoint> line = gauss_legendre_unit(n);
  DomainRule rule;
  for (const auto& [x, x_weight] : line)
    for (const auto& [y, y_weight] : line) {
      rule.points.push_back(triangle ? Vector2(x * (1 - y), x * y) : Vector2(x, y));
      rule.weights.push_back(x_weight * y_weight * (triangle ? x : 1.0));
    }
  return rule;
}

}  // namespace hariko

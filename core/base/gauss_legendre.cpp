#include "core/base/gauss_legendre.hpp"

#include <cmath>
#include <numbers>

namespace hariko {

std::vector<GaussPoint> gauss_legendre_unit(int count) {
  std::vector<GaussPoint> points(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    // Newton on the Legendre polynomial from Chebyshev's estimate; converges to full precision in a few
    // steps.
    double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
    double slope = 0;
    for (int step = 0; step < 100; ++step) {
      double p = 1, before = 0;
      for (int k = 1; k <= count; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = count * (x * p - before) / (x * x - 1);
      const double move = p / slope;
      x -= move;
      if (std::abs(move) < 1e-16) break;
    }
    points[static_cast<std::size_t>(count - 1 - i)] = {0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  }
  return points;
}

}  // namespace hariko

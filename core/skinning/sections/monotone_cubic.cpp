#include "core/skinning/sections/monotone_cubic.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

/// Three-point slope at an end, limited so that the first piece stays monotone.
double end_slope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 < 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

}  // namespace

std::vector<double> monotone_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> h, d, out(n);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    h.push_back(x[k + 1] - x[k]);
    d.push_back((y[k + 1] - y[k]) / h[k]);
  }
  if (n == 2) return {d[0], d[0]};
  for (std::size_t k = 1; k + 1 < n; ++k) {
    if (d[k - 1] * d[k] <= 0) continue;
    const double w1 = 2 * h[k] + h[k - 1], w2 = h[k] + 2 * h[k - 1];
    out[k] = (w1 + w2) / (w1 / d[k - 1] + w2 / d[k]);
  }
  out[0] = end_slope(h[0], h[1], d[0], d[1]);
  out[n - 1] = end_slope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
  return out;
}

double hermite(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& slope,
               double at) {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const std::size_t k =
      std::size_t(std::clamp<std::ptrdiff_t>(above - x.begin() - 1, 0, std::ptrdiff_t(x.size()) - 2));
  const double h = x[k + 1] - x[k], t = (at - x[k]) / h, s = 1 - t;
  return s * s * (1 + 2 * t) * y[k] + t * t * (1 + 2 * s) * y[k + 1] +
         h * t * s * (s * slope[k] - t * slope[k + 1]);
}

}  // namespace hariko

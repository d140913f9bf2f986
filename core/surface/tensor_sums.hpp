#pragma once

// Bernstein polynomials and tensor sums whose arithmetic is symmetric under reversal, so that neighbours get
// the same bits along a common side.

#include <array>
#include <span>

#include "core/base/vector.hpp"

namespace hariko {

inline constexpr int max_tensor_degree = 15;
using BernsteinValues = std::array<double, max_tensor_degree + 1>;

namespace tensor_detail {

constexpr auto make_binomials() {
  std::array<std::array<double, max_tensor_degree + 1>, max_tensor_degree + 1> out{};
  for (std::size_t n = 0; n <= max_tensor_degree; ++n) {
    out[n][0] = out[n][n] = 1;
    for (std::size_t k = 1; k < n; ++k) out[n][k] = out[n - 1][k - 1] + out[n - 1][k];
  }
  return out;
}
inline constexpr auto binomials = make_binomials();

}  // namespace tensor_detail

/// Bernstein polynomials of degree n at x, with y = 1 - x.
inline void bernstein(int n, double x, double y, BernsteinValues& out) {
  BernsteinValues px, py;
  px[0] = py[0] = 1;
  const auto degree = std::size_t(n);
  for (std::size_t k = 1; k <= degree; ++k) {
    px[k] = px[k - 1] * x;
    py[k] = py[k - 1] * y;
  }
  for (std::size_t i = 0; i <= degree; ++i)
    out[i] = tensor_detail::binomials[degree][i] * (px[i] * py[degree - i]);
}

/// Derivatives of the Bernstein polynomials of degree n from the values of degree n - 1; n >= 1.
inline void bernstein_derivative(int n, const BernsteinValues& lower, BernsteinValues& out) {
  const auto degree = std::size_t(n);
  for (std::size_t i = 0; i <= degree; ++i)
    out[i] = n * ((i > 0 ? lower[i - 1] : 0.0) - (i < degree ? lower[i] : 0.0));
}

/// Sum over i of weight[i] point[stride i], from both ends at the same time.
template <class Point>
Point symmetric_sum(int degree, const BernsteinValues& weight, const Point* point, int stride) {
  const auto n = std::size_t(degree);
  const auto at = [&](std::size_t i) -> const Point& { return point[i * std::size_t(stride)]; };
  Point out = weight[0] * at(0) + weight[n] * at(n);
  for (std::size_t i = 1; i + i < n; ++i) out += weight[i] * at(i) + weight[n - i] * at(n - i);
  if (n % 2 == 0) out += weight[n / 2] * at(n / 2);
  return out;
}

/// Tensor sum over i, j of s[i] t[j] control[j (p + 1) + i].
template <class Point>
Point tensor_sum(int p, int q, const BernsteinValues& s, const BernsteinValues& t, const Point* control) {
  std::array<Point, max_tensor_degree + 1> rows;
  for (int j = 0; j <= q; ++j) rows[std::size_t(j)] = symmetric_sum(p, s, control + j * (p + 1), 1);
  return symmetric_sum(q, t, rows.data(), 1);
}

/// Positions of a polynomial tensor patch at many parameters.
void tensor_positions(int p, int q, const Vector3* control, std::span<const Vector2> parameters,
                      std::span<Vector3> out);

}  // namespace hariko

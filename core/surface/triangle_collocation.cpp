#include "core/surface/triangle_collocation.hpp"

#include <Eigen/LU>
#include <cmath>
#include <memory>
#include <mutex>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

using Real = long double;

Real factorial(int n) {
  Real out = 1;
  for (int k = 2; k <= n; ++k) out *= k;
  return out;
}

Real power(Real x, int n) {
  Real out = 1;
  for (int k = 0; k < n; ++k) out *= x;
  return out;
}

/// Relative error of a sampled position; a generous bound.
constexpr double sample_rounding = 1e-15;

}  // namespace

TriangleCollocation::TriangleCollocation(int degree) : degree_(degree) {
  HARIKO_ASSERT(degree >= 1 && degree <= max_degree, "degree out of range");
  const GridPattern grid{Domain::triangle, degree};
  count_ = grid.point_count();
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix matrix(count_, count_);
  for (int j = 0; j <= degree; ++j)
    for (int i = 0; i + j <= degree; ++i) {
      const Real s = Real(i) / degree, t = Real(j) / degree, r = Real(degree - i - j) / degree;
      for (int l = 0; l <= degree; ++l)
        for (int k = 0; k + l <= degree; ++k) {
          const int m = degree - k - l;
          const Real multinomial = factorial(degree) / (factorial(k) * factorial(l) * factorial(m));
          matrix(grid.index(i, j), grid.index(k, l)) = multinomial * power(s, k) * power(t, l) * power(r, m);
        }
    }
  const Matrix inverse = matrix.partialPivLu().inverse();
  inverse_.resize(std::size_t(count_) * std::size_t(count_));
  amplification_.assign(std::size_t(count_), 0.0);
  for (int i = 0; i < count_; ++i)
    for (int k = 0; k < count_; ++k) {
      const double value = static_cast<double>(inverse(i, k));
      inverse_[std::size_t(i * count_ + k)] = std::abs(value) < 1e-13 ? 0 : value;
      amplification_[std::size_t(i)] += std::abs(value);
    }
}

void TriangleCollocation::controls(std::span<const Vector3> samples, std::span<HullBall> out) const {
  // Relative to the first corner, so that rounding errors are relative to the triangle's size.
  const Vector3 base = samples[0];
  double local[3][91];
  static_assert((max_degree + 1) * (max_degree + 2) / 2 == 91);
  double extent = 0;
  for (int k = 0; k < count_; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      local[axis][k] = samples[std::size_t(k)][axis] - base[axis];
      extent = std::max(extent, std::abs(samples[std::size_t(k)][axis]));
    }
  for (int i = 0; i < count_; ++i) {
    const double* weight = row(i);
    double x = 0, y = 0, z = 0;
    for (int k = 0; k < count_; ++k) {
      x += weight[k] * local[0][k];
      y += weight[k] * local[1][k];
      z += weight[k] * local[2][k];
    }
    HullBall& ball = out[std::size_t(i)];
    ball.centre = base + Vector3(x, y, z);
    ball.radius = sample_rounding * amplification_[std::size_t(i)] * extent;
  }
}

const TriangleCollocation& triangle_collocation(int degree) {
  HARIKO_ASSERT(degree >= 1 && degree <= TriangleCollocation::max_degree, "degree out of range");
  constexpr std::size_t count = TriangleCollocation::max_degree + 1;
  static std::array<std::once_flag, count> made;
  static std::array<std::unique_ptr<const TriangleCollocation>, count> tables;
  const auto at = std::size_t(degree);
  std::call_once(made[at], [&] { tables[at] = std::make_unique<const TriangleCollocation>(degree); });
  return *tables[at];
}

}  // namespace hariko

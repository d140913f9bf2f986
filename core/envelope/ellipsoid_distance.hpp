#pragma once

// Signed distance to axis-aligned ellipsoids and ellipses.

#include <algorithm>
#include <cmath>

#include "core/base/vector.hpp"

namespace hariko {

/// Nearest point of an ellipse (N = 2) or an ellipsoid (N = 3).
template <int N>
struct AxesPlace {
  double distance;                     ///< negative inside
  Eigen::Matrix<double, N, 1> normal;  ///< unit, outward, at the nearest point
  Eigen::Matrix<double, N, 1> nearest;
};

/// Nearest point and distance, exact to rounding. `half`: positive half axes. Newton steps for s = t + half^2
/// of the least axis lead to the nearest point, half^2 p / (t + half^2) (docs/envelope.md).
template <int N>
AxesPlace<N> axes_place(const Eigen::Matrix<double, N, 1>& half, const Eigen::Matrix<double, N, 1>& point) {
  using Vector = Eigen::Matrix<double, N, 1>;
  const double size = half.maxCoeff(), least = half.minCoeff();
  if (least == size) {
    const double r = point.norm();
    const Vector n = r > 0 ? Vector(point / r) : Vector(Vector::Unit(0));
    return {r - size, n, size * n};
  }
  // Points in a plane of symmetry may have two nearest points; beside it there is one.
  Vector p, more;
  double s = 0;
  for (int i = 0; i < N; ++i) {
    const double beside = 1e-16 * half[i];
    p[i] = std::abs(point[i]) < beside ? (point[i] < 0 ? -beside : beside) : point[i];
    more[i] = (half[i] - least) * (half[i] + least);
    s = std::max(s, half[i] * std::abs(p[i]) - more[i]);
  }
  for (int round = 0; round < 60; ++round) {
    double value = -1, slope = 0;
    for (int i = 0; i < N; ++i) {
      const double own = s + more[i], q = half[i] * p[i] / own;
      value += q * q;
      slope -= 2 * q * q / own;
    }
    const double step = -value / slope;
    if (!(step > 1e-15 * s)) break;
    s += step;
  }
  AxesPlace<N> out;
  double sum = -1;
  for (int i = 0; i < N; ++i) {
    const double q = p[i] / (s + more[i]);
    out.nearest[i] = half[i] * half[i] * q;
    out.normal[i] = q;
    sum += p[i] * q;
  }
  out.normal.normalize();
  // The square of the distance as Lagrange's function of t, which has its maximum at the root: errors of t
  // have an effect of second order.
  const double t = s - least * least;
  out.distance = std::copysign(std::sqrt(std::max(t * sum, 0.0)), t);
  return out;
}

}  // namespace hariko

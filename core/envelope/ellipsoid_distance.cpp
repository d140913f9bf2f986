#include "core/envelope/ellipsoid_distance.hpp"

#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

template <int N>
struct AxesPlace {
  double distance;
  Eigen::Matrix<double, N, 1> normal, nearest;
};

/// The nearest point is half^2 p / s, with s = t + half^2 per axis and t the root of sum (half p / s)^2 = 1
/// above -least half^2. The sum is convex and falls there, so Newton steps from the left end never pass the
/// root. The unknown is the s of the least axis: inside, near the plane across that axis, it is nearly 0, and
/// the sum of t and half^2 would lose all its digits.
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

}  // namespace

EllipsoidPlace ellipsoid_place(const Vector3& half, const Vector3& point) {
  const AxesPlace<3> at = axes_place<3>(half, point);
  return {at.distance, at.normal, at.nearest};
}

EllipsePlace ellipse_place(const Vector2& half, const Vector2& point) {
  const AxesPlace<2> at = axes_place<2>(half, point);
  return {at.distance, at.normal, at.nearest};
}

}  // namespace hariko

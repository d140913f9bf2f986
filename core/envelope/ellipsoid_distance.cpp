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

/// The nearest point is half^2 p / (t + half^2), with t the root of sum (half p / (t + half^2))^2 = 1 above
/// -least half^2. The sum is convex and falls there, so Newton steps from the left end never pass the root.
template <int N>
AxesPlace<N> axes_place(const Eigen::Matrix<double, N, 1>& half, const Eigen::Matrix<double, N, 1>& point) {
  using Vector = Eigen::Matrix<double, N, 1>;
  const double size = half.maxCoeff();
  if (half.minCoeff() == size) {
    const double r = point.norm();
    const Vector n = r > 0 ? Vector(point / r) : Vector(Vector::Unit(0));
    return {r - size, n, size * n};
  }
  // Points in a plane of symmetry may have two nearest points; beside it there is one.
  Vector p;
  for (int i = 0; i < N; ++i) {
    const double least = 1e-12 * half[i];
    p[i] = std::abs(point[i]) < least ? (point[i] < 0 ? -least : least) : point[i];
  }
  double t = -1e300;
  for (int i = 0; i < N; ++i) t = std::max(t, half[i] * std::abs(p[i]) - half[i] * half[i]);
  for (int round = 0; round < 60; ++round) {
    double value = -1, slope = 0;
    for (int i = 0; i < N; ++i) {
      const double s = t + half[i] * half[i], q = half[i] * p[i] / s;
      value += q * q;
      slope -= 2 * q * q / s;
    }
    const double step = -value / slope;
    if (!(step > 1e-15 * size * size)) break;
    t += step;
  }
  AxesPlace<N> out;
  Vector normal;
  for (int i = 0; i < N; ++i) {
    const double s = t + half[i] * half[i];
    out.nearest[i] = half[i] * half[i] * p[i] / s;
    normal[i] = p[i] / s;
  }
  const double length = normal.norm();
  out.normal = normal / length;
  out.distance = t * length;
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

#include "core/analysis/curvature.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace hariko {

std::optional<Curvature> curvature(const PatchPoint& point) {
  Curvature out;
  out.normal = unit_normal(point);
  if (out.normal.isZero(0)) return std::nullopt;

  // Orthonormal tangent frame e1, e2 with ds = a e1, dt = b e1 + c e2.
  const double a = point.ds.stableNorm();
  const Vector3 e1 = point.ds / a;
  const Vector3 e2 = out.normal.cross(e1);
  const double b = point.dt.dot(e1), c = point.dt.dot(e2);

  // Second fundamental form against the inward normal, carried over to the frame.
  const double l = -point.dss.dot(out.normal), m = -point.dst.dot(out.normal), n = -point.dtt.dot(out.normal);
  const double t11 = l / (a * a);
  const double t12 = (m / a - b * t11) / c;
  const double t22 = ((n / c - 2 * b * t12) - b * b / c * t11) / c;

  out.mean = (t11 + t22) / 2;
  out.gauss = t11 * t22 - t12 * t12;
  const double half = (t11 - t22) / 2;
  const double radius = std::hypot(half, t12);
  out.k1 = out.mean + radius;
  out.k2 = out.mean - radius;
  if (!std::isfinite(out.k1) || !std::isfinite(out.k2) || !std::isfinite(out.gauss)) return std::nullopt;

  const double angle = radius > 0 ? std::atan2(t12, half) / 2 : 0;
  out.direction1 = std::cos(angle) * e1 + std::sin(angle) * e2;
  out.direction2 = -std::sin(angle) * e1 + std::cos(angle) * e2;
  out.tensor = t11 * e1 * e1.transpose() + t12 * (e1 * e2.transpose() + e2 * e1.transpose()) +
               t22 * e2 * e2.transpose();
  return out;
}

}  // namespace hariko

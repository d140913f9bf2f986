#include "core/analysis/curvature.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace hariko {

Matrix3 ShapeOperator::tensor() const {
  return t11 * e1 * e1.transpose() + t12 * (e1 * e2.transpose() + e2 * e1.transpose()) +
         t22 * e2 * e2.transpose();
}

std::optional<ShapeOperator> shape_operator(const PatchPoint& point) {
  ShapeOperator out;
  out.normal = unit_normal(point);
  if (out.normal.isZero(0)) return std::nullopt;

  // Orthonormal tangent frame e1, e2 with ds = a e1, dt = b e1 + c e2.
  const double a = point.ds.stableNorm();
  out.e1 = point.ds / a;
  out.e2 = out.normal.cross(out.e1);
  const double b = point.dt.dot(out.e1), c = point.dt.dot(out.e2);

  // Second fundamental form against the inward normal, carried over to the frame.
  const double l = -point.dss.dot(out.normal), m = -point.dst.dot(out.normal), n = -point.dtt.dot(out.normal);
  out.t11 = l / (a * a);
  out.t12 = (m / a - b * out.t11) / c;
  out.t22 = ((n / c - 2 * b * out.t12) - b * b / c * out.t11) / c;
  const bool finite =
      std::isfinite(out.mean()) && std::isfinite(out.t11 - out.t22) && std::isfinite(out.gauss());
  if (!finite) return std::nullopt;
  return out;
}

std::optional<Curvature> curvature(const PatchPoint& point) {
  const auto shape = shape_operator(point);
  if (!shape) return std::nullopt;
  Curvature out;
  out.normal = shape->normal;
  out.mean = shape->mean();
  out.gauss = shape->gauss();
  const double half = (shape->t11 - shape->t22) / 2;
  const double radius = std::hypot(half, shape->t12);
  out.k1 = out.mean + radius;
  out.k2 = out.mean - radius;
  if (!std::isfinite(out.k1) || !std::isfinite(out.k2)) return std::nullopt;

  const double angle = radius > 0 ? std::atan2(shape->t12, half) / 2 : 0;
  out.direction1 = std::cos(angle) * shape->e1 + std::sin(angle) * shape->e2;
  out.direction2 = -std::sin(angle) * shape->e1 + std::cos(angle) * shape->e2;
  out.tensor = shape->tensor();
  return out;
}

}  // namespace hariko

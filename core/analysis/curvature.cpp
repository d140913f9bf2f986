#include "core/analysis/curvature.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace hariko {

namespace {

/// Sine of the angle between ds and dt up to which they count as parallel (as in `unit_normal`).
constexpr double parallel = 1e-12;

/// Shape operator for extreme lengths: by parameters along which ds and dt have length one.
std::optional<ShapeOperator> of_extreme_lengths(const PatchPoint& point) {
  const double s = point.ds.stableNorm(), t = point.dt.stableNorm();
  if (!(s > 0 && t > 0) || !std::isfinite(s) || !std::isfinite(t)) return std::nullopt;
  PatchPoint even = point;
  even.ds = point.ds / s;
  even.dt = point.dt / t;
  even.dss = point.dss / s / s;
  even.dst = point.dst / s / t;
  even.dtt = point.dtt / t / t;
  return shape_operator(even);
}

}  // namespace

Matrix3 ShapeOperator::tensor() const {
  return t11 * e1 * e1.transpose() + t12 * (e1 * e2.transpose() + e2 * e1.transpose()) +
         t22 * e2 * e2.transpose();
}

std::optional<ShapeOperator> shape_operator(const PatchPoint& point) {
  // First fundamental form [e f; f g] and area element w, w^2 = e g - f^2. The squares of the lengths must
  // keep all their digits; more extreme lengths are scaled to one first, a change of parameters that leaves
  // the shape operator unchanged.
  constexpr double least = 1e-100, most = 1e100;
  const double e = point.ds.squaredNorm(), g = point.dt.squaredNorm();
  if (!(e > least && e < most && g > least && g < most)) return of_extreme_lengths(point);

  ShapeOperator out;
  const Vector3 cross = point.ds.cross(point.dt);
  const double square = cross.squaredNorm();
  if (!(square > parallel * parallel * (e * g))) return std::nullopt;
  const double f = point.ds.dot(point.dt), inverse_w = 1 / std::sqrt(square), inverse_e = 1 / e;
  out.normal = inverse_w * cross;
  out.e1 = std::sqrt(inverse_e) * point.ds;
  out.e2 = out.normal.cross(out.e1);

  // Second fundamental form [l m; m n] against the inward normal, carried over to the frame e1, e2 with
  // ds = a e1, dt = b e1 + c e2, where a^2 = e, b / c = f / w and 1 / c^2 = e / w^2.
  const double l = -point.dss.dot(out.normal), m = -point.dst.dot(out.normal), n = -point.dtt.dot(out.normal);
  const double slope = f * inverse_w;
  out.t11 = l * inverse_e;
  out.t12 = (m - f * out.t11) * inverse_w;
  out.t22 = n * e * (inverse_w * inverse_w) - slope * (2 * out.t12 + slope * out.t11);
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
  out.tensor = shape->tensor();
  return out;
}

}  // namespace hariko

#include "core/geometry/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hariko {

Eigen::Quaterniond least_rotation(const Vector3& from, const Vector3& to) {
  const Vector3 a = from.stableNormalized(), b = to.stableNormalized();
  if (!(a.squaredNorm() > 0) || !(b.squaredNorm() > 0)) return Eigen::Quaterniond::Identity();
  // Sine and cosine of half the angle: exact for small angles and for nearly opposite directions.
  const double cosine = 0.5 * (a + b).norm(), sine = 0.5 * (a - b).norm();
  // Direction of a x b, without the rounding errors of nearly parallel directions.
  Vector3 axis = a.cross(sine < cosine ? Vector3(b - a) : Vector3(a + b));
  if (!(axis.squaredNorm() > 0)) axis = a.unitOrthogonal();
  Eigen::Quaterniond out;
  out.w() = cosine;
  out.vec() = sine * axis.stableNormalized();
  return out.normalized();
}

}  // namespace hariko

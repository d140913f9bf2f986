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

Vector3 carried_along(const Vector3& across, const Vector3& from, const Vector3& to, const Vector3& chord) {
  const double first = chord.squaredNorm();
  Vector3 next;
  if (first > 0) {
    const Vector3 middle = across - (2 / first) * chord.dot(across) * chord;
    const Vector3 turned = from - (2 / first) * chord.dot(from) * chord;
    const Vector3 rest = to - turned;
    const double second = rest.squaredNorm();
    next = second > 0 ? Vector3(middle - (2 / second) * rest.dot(middle) * rest) : middle;
  } else {
    next = least_rotation(from, to) * across;
  }
  next -= next.dot(to) * to;
  return next.normalized();
}

}  // namespace hariko

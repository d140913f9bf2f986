#include "core/base/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hariko {

namespace {

/// Householder's reflection that leaves only entry `at` of x from there on: I - factor v v^T,
/// where v is 1 at `at`, and below what x is left with. Returns the factor.
double reflection(Vector3& x, Eigen::Index at) {
  double tail = x[2] * x[2];
  if (at == 0) tail = x[1] * x[1] + tail;
  const double first = x[at];
  if (tail <= std::numeric_limits<double>::min()) {
    for (Eigen::Index i = at + 1; i < 3; ++i) x[i] = 0;
    return 0;
  }
  const double root = std::sqrt(first * first + tail), kept = first >= 0 ? -root : root;
  for (Eigen::Index i = at + 1; i < 3; ++i) x[i] /= first - kept;
  return (kept - first) / kept;
}

void reflect(const Vector3& v, double factor, Eigen::Index at, Vector3& x) {
  double along = v[2] * x[2];
  if (at == 0) along = v[1] * x[1] + along;
  along += x[at];
  x[at] -= factor * along;
  for (Eigen::Index i = at + 1; i < 3; ++i) x[i] -= v[i] * factor * along;
}

/// A unit vector across both of two opposite unit vectors, but for rounding: the last column of Q of their QR
/// factorisation with the longer one first.
Vector3 across_opposites(Vector3 a, Vector3 b) {
  if (b.norm() > a.norm()) a.swap(b);
  const double first = reflection(a, 0);
  reflect(a, first, 0, b);
  const double second = reflection(b, 1);
  Vector3 out = Vector3::UnitZ();
  reflect(b, second, 1, out);
  reflect(a, first, 0, out);
  return out;
}

}  // namespace

Eigen::Quaterniond least_rotation(const Vector3& from, const Vector3& to) {
  const Vector3 a = from.stableNormalized(), b = to.stableNormalized();
  if (!(a.squaredNorm() > 0) || !(b.squaredNorm() > 0)) return Eigen::Quaterniond::Identity();
  // Half of the angle by its sine and cosine: exact for small angles and for nearly opposite directions.
  const double cosine = 0.5 * (a + b).norm(), sine = 0.5 * (a - b).norm();
  // a x b, without the rounding of nearly parallel directions.
  Vector3 axis = a.cross(sine < cosine ? Vector3(b - a) : Vector3(a + b));
  if (!(axis.squaredNorm() > 0)) axis = a.unitOrthogonal();
  Eigen::Quaterniond out;
  out.w() = cosine;
  out.vec() = sine * axis.stableNormalized();
  return out.normalized();
}

Matrix3 turn_of_z(const Vector3& direction) {
  const Vector3 z = Vector3::UnitZ(), to = direction.normalized();
  const double cosine = to.dot(z);
  Eigen::Quaterniond out;
  if (cosine < -1 + 1e-12) {
    const double square = (1 + std::max(cosine, -1.0)) * 0.5;
    out.w() = std::sqrt(square);
    out.vec() = across_opposites(z, to) * std::sqrt(1 - square);
  } else {
    const double root = std::sqrt((1 + cosine) * 2);
    out.vec() = z.cross(to) * (1 / root);
    out.w() = root * 0.5;
  }
  return out.toRotationMatrix();
}

}  // namespace hariko

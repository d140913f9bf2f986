#include "core/geometry/orientation.hpp"

#include <array>
#include <cmath>

#include "core/geometry/expansion.hpp"

namespace hariko {
namespace {

Expansion difference(double a, double b) {
  return Expansion::difference(a, b);
}

int exact_side(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  std::array<std::array<Expansion, 3>, 3> rows;
  for (int k = 0; k < 3; ++k) {
    rows[0][std::size_t(k)] = difference(b[k], a[k]);
    rows[1][std::size_t(k)] = difference(c[k], a[k]);
    rows[2][std::size_t(k)] = difference(d[k], a[k]);
  }
  const auto minor = [&](std::size_t i, std::size_t j) {
    return rows[0][i] * rows[1][j] - rows[0][j] * rows[1][i];
  };
  return (minor(0, 1) * rows[2][2] + minor(1, 2) * rows[2][0] + minor(2, 0) * rows[2][1]).sign();
}

}  // namespace

int side_of_plane(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  // Static filter: the error bound of orient3d's stage A (Shewchuk 1997).
  const Vector3 u = b - a, v = c - a, w = d - a;
  const double xy = u.x() * v.y(), yx = u.y() * v.x();
  const double yz = u.y() * v.z(), zy = u.z() * v.y();
  const double zx = u.z() * v.x(), xz = u.x() * v.z();
  const double determinant = w.z() * (xy - yx) + w.x() * (yz - zy) + w.y() * (zx - xz);
  const double permanent = std::abs(w.z()) * (std::abs(xy) + std::abs(yx)) +
                           std::abs(w.x()) * (std::abs(yz) + std::abs(zy)) +
                           std::abs(w.y()) * (std::abs(zx) + std::abs(xz));
  constexpr double epsilon = 0x1p-53;
  const double bound = (7 + 56 * epsilon) * epsilon * permanent;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_side(a, b, c, d);
}

}  // namespace hariko

#include "core/skinning/columns/knot_shift.hpp"

#include <array>
#include <cmath>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

constexpr int degree = 7;
/// Poles of the interpolation filter: the roots inside the unit circle of the B-spline's values at integers
/// (1, 120, 1191, 2416, ...).
constexpr std::array poles{-0.53528043079643816554, -0.12255461519232669052, -0.00914869480960827693};

/// Values of the eight B-splines at fraction t of a span, by the recursion of Cox and de Boor.
std::array<double, degree + 1> basis(double t) {
  std::array<double, degree + 1> b{1};
  for (int d = 1; d <= degree; ++d)
    for (int j = d; j >= 0; --j) {
      const double before = j > 0 ? b[std::size_t(j) - 1] : 0, own = j < d ? b[std::size_t(j)] : 0;
      b[std::size_t(j)] = ((t - (j - d)) * before + (j + 1 - t) * own) / d;
    }
  return b;
}

/// Applies the filter 1 / ((1 - pole z^-1)(1 - pole z)), periodically.
void filter(std::vector<Vector3>& c, double pole) {
  const std::size_t n = c.size();
  const auto turn = [&](auto&& sample) {
    Vector3 sum = Vector3::Zero();
    double power = 1;
    for (std::size_t k = 0; k < n; ++k, power *= pole) sum += power * sample(k);
    return Vector3(sum / (1 - power));
  };
  c[0] = turn([&](std::size_t k) { return c[(n - k) % n]; });
  for (std::size_t i = 1; i < n; ++i) c[i] += pole * c[i - 1];
  c[n - 1] = -pole * turn([&](std::size_t k) { return c[(n - 1 + k) % n]; });
  for (std::size_t i = n - 1; i-- > 0;) c[i] = pole * (c[i + 1] - c[i]);
}

}  // namespace

KnotShift::KnotShift(std::vector<Vector3> points) : coefficients_(std::move(points)) {
  HARIKO_ASSERT(coefficients_.size() >= 3, "closed curves have three points");
  double gain = 1;
  for (const double pole : poles) gain *= (1 - pole) * (1 - 1 / pole);
  for (const double pole : poles) filter(coefficients_, pole);
  for (Vector3& c : coefficients_) c *= gain;
}

Vector3 KnotShift::at(double x) const {
  const auto n = static_cast<long>(coefficients_.size());
  const double floor = std::floor(x);
  const auto weights = basis(x - floor);
  const long first = long(std::fmod(floor, double(n))) - 3 + 2 * n;
  Vector3 out = Vector3::Zero();
  for (int j = 0; j <= degree; ++j)
    out += weights[std::size_t(j)] * coefficients_[std::size_t((first + j) % n)];
  return out;
}

}  // namespace hariko

#pragma once

// Rational cubic curves with a vector field across them, and the cross-boundary derivative with which patches
// meet tangent-plane continuously (Ogasawara and Kobori, eq. 1; docs/envelope.md).

#include <Eigen/Core>
#include <array>
#include <utility>

#include "core/base/vector.hpp"

namespace hariko {

/// Homogeneous coordinates (w x, w y, w z, w).
using Homogeneous = Eigen::Vector4d;
template <std::size_t Degree>
using BernsteinForm = std::array<Homogeneous, Degree + 1>;
using HomogeneousCubic = BernsteinForm<3>;
using HomogeneousSextic = BernsteinForm<6>;

/// Homogeneous coordinates of a point with weight w.
inline Homogeneous homogeneous(const Vector3& p, double w = 1) {
  return {w * p.x(), w * p.y(), w * p.z(), w};
}
/// Cartesian coordinates of a homogeneous point.
inline Vector3 cartesian(const Homogeneous& h) {
  return h.head<3>() / h.w();
}

/// Curve of the network, seen from one of its faces: the face lies to the left, and `across` points into it.
/// The field across is linear, given at start and end.
struct RibbonCurve {
  HomogeneousCubic curve{Homogeneous::Zero(), Homogeneous::Zero(), Homogeneous::Zero(), Homogeneous::Zero()};
  std::array<Vector3, 2> across{Vector3::Zero(), Vector3::Zero()};

  RibbonCurve reversed() const {
    return {{curve[3], curve[2], curve[1], curve[0]}, {-across[1], -across[0]}};
  }
  /// Splits the curve at 1/2 by de Casteljau's algorithm. The parts of the reversed curve are the reversed
  /// parts, bit for bit.
  std::pair<RibbonCurve, RibbonCurve> halves() const;

  Vector3 start() const { return cartesian(curve[0]); }
  Vector3 end() const { return cartesian(curve[3]); }
  Vector3 middle() const;
  /// Cartesian derivative by the parameter.
  Vector3 start_derivative() const;
  Vector3 end_derivative() const;
  Vector3 middle_derivative() const;
  Homogeneous start_rate() const { return 3 * (curve[1] - curve[0]); }  ///< homogeneous derivative
  Homogeneous end_rate() const { return 3 * (curve[3] - curve[2]); }
};

/// Coefficients of eq. (1'): r = k F + h (P_v w - P w_v) + mu P, Bernstein.
struct CrossCoefficients {
  double k[3], h[3], mu[2];
};

/// Coefficients for which the derivative across has these values at the ends (homogeneous) and approximates
/// `middle` (Cartesian) at 1/2.
CrossCoefficients cross_coefficients(const RibbonCurve& ribbon, const Homogeneous& start,
                                     const Homogeneous& end, const Vector3& middle);
/// Derivative across the curve by eq. (1'). Where h is linear it has degree 5 (five times b0 .. b5 of the
/// paper) and is elevated.
HomogeneousSextic cross_field(const RibbonCurve& ribbon, const CrossCoefficients& coefficients);

/// Tangent direction w P_v - w_v P of a rational cubic P / w: Bezier coefficients, degree 4, the last
/// component zero.
BernsteinForm<4> tangent_direction(const HomogeneousCubic& curve);

/// Product of a scalar and a vector polynomial, both in Bernstein form.
template <std::size_t M, std::size_t N>
BernsteinForm<M + N> bernstein_product(const std::array<double, M + 1>& a, const BernsteinForm<N>& b) {
  constexpr auto choose = [](std::size_t n, std::size_t k) {
    double out = 1;
    for (std::size_t i = 0; i < k; ++i) out = out * double(n - i) / double(i + 1);
    return out;
  };
  BernsteinForm<M + N> out;
  out.fill(Homogeneous::Zero());
  for (std::size_t i = 0; i <= M; ++i)
    for (std::size_t j = 0; j <= N; ++j)
      out[i + j] += choose(M, i) * choose(N, j) / choose(M + N, i + j) * a[i] * b[j];
  return out;
}

}  // namespace hariko

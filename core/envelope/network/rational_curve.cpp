#include "core/envelope/network/rational_curve.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hariko {

namespace {

Homogeneous weighted(const Vector3& v) {
  return {v.x(), v.y(), v.z(), 0};
}

/// Both halves by de Casteljau's triangle at 1/2: its first and last row.
std::pair<HomogeneousCubic, HomogeneousCubic> split(const HomogeneousCubic& c) {
  const Homogeneous ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), cd = 0.5 * (c[2] + c[3]);
  const Homogeneous abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd);
  const Homogeneous middle = 0.5 * (abc + bcd);
  return {{c[0], ab, abc, middle}, {middle, bcd, cd, c[3]}};
}

}  // namespace

std::pair<RibbonCurve, RibbonCurve> RibbonCurve::halves() const {
  const auto [first, second] = split(curve);
  const Vector3 middle = 0.5 * (across[0] + across[1]);
  return {{first, {across[0], middle}}, {second, {middle, across[1]}}};
}

Vector3 RibbonCurve::middle() const {
  return cartesian(split(curve).first[3]);
}
Vector3 RibbonCurve::start_derivative() const {
  return 3 * curve[1].w() / curve[0].w() * (cartesian(curve[1]) - cartesian(curve[0]));
}
Vector3 RibbonCurve::end_derivative() const {
  return 3 * curve[2].w() / curve[3].w() * (cartesian(curve[3]) - cartesian(curve[2]));
}
Vector3 RibbonCurve::middle_derivative() const {
  const auto [first, second] = split(curve);
  const Homogeneous rate = 3 * (second[1] - first[2]);
  const Homogeneous& at = first[3];
  return (rate.head<3>() - cartesian(at) * rate.w()) / at.w();
}

BernsteinForm<4> tangent_direction(const HomogeneousCubic& c) {
  const std::array<double, 4> w{c[0].w(), c[1].w(), c[2].w(), c[3].w()};
  const std::array<double, 3> dw{3 * (w[1] - w[0]), 3 * (w[2] - w[1]), 3 * (w[3] - w[2])};
  const BernsteinForm<2> dx{3 * (c[1] - c[0]), 3 * (c[2] - c[1]), 3 * (c[3] - c[2])};
  const BernsteinForm<5> a = bernstein_product<3, 2>(w, dx), b = bernstein_product<2, 3>(dw, c);
  BernsteinForm<5> full;
  for (std::size_t i = 0; i < 6; ++i) full[i] = a[i] - b[i];
  // The leading term cancels: reduces to degree 4 from both ends, so that neither end collects all of the
  // rounding.
  BernsteinForm<4> out;
  out[0] = full[0];
  out[1] = (5 * full[1] - out[0]) / 4;
  out[4] = full[5];
  out[3] = (5 * full[4] - out[4]) / 4;
  out[2] = 0.5 * ((5 * full[2] - 2 * out[1]) / 3 + (5 * full[3] - 2 * out[3]) / 3);
  for (Homogeneous& h : out) h.w() = 0;
  return out;
}

CrossCoefficients cross_coefficients(const RibbonCurve& ribbon, const Homogeneous& start,
                                     const Homogeneous& end, const Vector3& middle) {
  CrossCoefficients out;
  const BernsteinForm<4> along = tangent_direction(ribbon.curve);
  double k[2], h[2];
  for (std::size_t e = 0; e < 2; ++e) {
    const Homogeneous& d = e == 0 ? start : end;
    const Homogeneous& at = ribbon.curve[3 * e];
    out.mu[e] = d.w() / at.w();
    const Vector3 r = (d - out.mu[e] * at).head<3>();
    const Vector3 &f = ribbon.across[e], w = along[4 * e].head<3>();
    const double ff = f.dot(f), fw = f.dot(w), ww = w.dot(w), determinant = ff * ww - fw * fw;
    k[e] = determinant > 0 ? (ww * f.dot(r) - fw * w.dot(r)) / determinant : 0;
    h[e] = determinant > 0 ? (ff * w.dot(r) - fw * f.dot(r)) / determinant : 0;
  }
  const double mean = 0.5 * (k[0] + k[1]);
  double km = mean;
  const Vector3 tangent = ribbon.middle_derivative();
  Vector3 a = 0.5 * (ribbon.across[0] + ribbon.across[1]);
  a -= a.dot(tangent) / tangent.squaredNorm() * tangent;
  const double w =
      (ribbon.curve[0].w() + ribbon.curve[3].w() + 3 * (ribbon.curve[1].w() + ribbon.curve[2].w())) / 8;
  if (a.squaredNorm() > 0) km = w * middle.dot(a) / a.squaredNorm();
  // Clamped relative to the linear one: a fuller field folds.
  if (mean != 0 && std::isfinite(km))
    km = mean * std::clamp(km / mean, 0.5, 2.0);
  else
    km = mean;
  out.k[0] = k[0];
  out.k[1] = 2 * km - mean;
  out.k[2] = k[1];
  // Removes the component along the curve, which arises because the tangent is longer in the middle than at
  // the ends.
  const Vector3 f = 0.5 * (ribbon.across[0] + ribbon.across[1]), speed = w * w * tangent;
  const double straight = 0.5 * (h[0] + h[1]);
  double hm = (w * middle - km * f).dot(speed) / speed.squaredNorm();
  if (!std::isfinite(hm)) hm = straight;
  out.h[0] = h[0];
  out.h[1] = 2 * hm - straight;
  out.h[2] = h[1];
  return out;
}

HomogeneousSextic cross_field(const RibbonCurve& ribbon, const CrossCoefficients& c) {
  const BernsteinForm<1> across{weighted(ribbon.across[0]), weighted(ribbon.across[1])};
  const BernsteinForm<3> kf = bernstein_product<2, 1>({c.k[0], c.k[1], c.k[2]}, across);
  const BernsteinForm<6> k = bernstein_product<3, 3>({1, 1, 1, 1}, kf);
  const BernsteinForm<6> h =
      bernstein_product<2, 4>({c.h[0], c.h[1], c.h[2]}, tangent_direction(ribbon.curve));
  const BernsteinForm<4> mp = bernstein_product<1, 3>({c.mu[0], c.mu[1]}, ribbon.curve);
  const BernsteinForm<6> m = bernstein_product<2, 4>({1, 1, 1}, mp);
  HomogeneousSextic out;
  for (std::size_t i = 0; i < 7; ++i) out[i] = k[i] + h[i] + m[i];
  return out;
}

}  // namespace hariko

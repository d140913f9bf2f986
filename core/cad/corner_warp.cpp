#include "core/cad/corner_warp.hpp"

#include <cmath>
#include <numbers>

namespace hariko {

CornerWarp::CornerWarp(int corner, double exponent)
    : corner_s_(corner == 1 || corner == 2 ? 1 : 0),
      corner_t_(corner == 2 || corner == 3 ? 1 : 0),
      power_(exponent - 1) {}

Vector2 CornerWarp::from_corner(const Vector2& at) const {
  return {std::abs(at.x() - corner_s_), std::abs(at.y() - corner_t_)};
}

Vector2 CornerWarp::map(const Vector2& at) const {
  const Vector2 own = from_corner(at);
  const double r = own.x() + own.y() - own.x() * own.y();
  if (!(r > 0)) return at;
  const Vector2 image = own * std::pow(r, power_);
  return {corner_s_ > 0 ? 1 - image.x() : image.x(), corner_t_ > 0 ? 1 - image.y() : image.y()};
}

PatchPoint CornerWarp::pull_back(const PatchPoint& point, const Vector2& at, Order order) const {
  const Vector2 own = from_corner(at);
  const double u = own.x(), v = own.y(), r = u + v - u * v, q = power_;
  // g = r^q and its derivatives.
  const double g = std::pow(r, q), by_r = q * g / r, by_rr = (q - 1) * by_r / r;
  const double r_u = 1 - v, r_v = 1 - u;
  const double g_u = by_r * r_u, g_v = by_r * r_v;
  const double g_uu = by_rr * r_u * r_u, g_vv = by_rr * r_v * r_v, g_uv = by_rr * r_u * r_v - by_r;
  // Derivatives of the image (u g, v g), with signs where the corner lies at 1.
  const double flip_s = corner_s_ > 0 ? -1 : 1, flip_t = corner_t_ > 0 ? -1 : 1;
  const double a_u = g + u * g_u, a_v = flip_s * flip_t * u * g_v, b_u = flip_s * flip_t * v * g_u,
               b_v = g + v * g_v;
  PatchPoint out;
  out.position = point.position;
  out.ds = a_u * point.ds + b_u * point.dt;
  out.dt = a_v * point.ds + b_v * point.dt;
  if (order == Order::first) return out;
  const double a_uu = flip_s * (2 * g_u + u * g_uu), a_uv = flip_t * (g_v + u * g_uv),
               a_vv = flip_s * u * g_vv, b_uu = flip_t * v * g_uu, b_uv = flip_s * (g_u + v * g_uv),
               b_vv = flip_t * (2 * g_v + v * g_vv);
  const auto second = [&](double a1, double b1, double a2, double b2) -> Vector3 {
    return a1 * a2 * point.dss + (a1 * b2 + a2 * b1) * point.dst + b1 * b2 * point.dtt;
  };
  out.dss = second(a_u, b_u, a_u, b_u) + a_uu * point.ds + b_uu * point.dt;
  out.dst = second(a_u, b_u, a_v, b_v) + a_uv * point.ds + b_uv * point.dt;
  out.dtt = second(a_v, b_v, a_v, b_v) + a_vv * point.ds + b_vv * point.dt;
  return out;
}

double warp_exponent(int valence) {
  const double c = std::cos(2 * std::numbers::pi / valence);
  const double subdominant = (5 + c + std::sqrt((9 + c) * (1 + c))) / 16;
  return -std::numbers::ln2 / std::log(subdominant);
}

}  // namespace hariko

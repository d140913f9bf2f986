#pragma once

// Jet3: a function of two variables with its derivatives up to the third order at a point, with the
// operations of Jet2.

#include "core/g2/faces/jet2.hpp"

namespace hariko {

/// Value and derivatives up to the third order of a function of two variables at a point.
struct Jet3 {
  double v = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, xxx = 0, xxy = 0, xyy = 0, yyy = 0;

  static Jet3 constant(double c) { return {c, 0, 0, 0, 0, 0, 0, 0, 0, 0}; }
  /// Linear function value + ax (x - x0) + ay (y - y0).
  static Jet3 linear(double value, double ax, double ay) { return {value, ax, ay, 0, 0, 0, 0, 0, 0, 0}; }

  Jet3& operator+=(const Jet3& b) {
    v += b.v, x += b.x, y += b.y, xx += b.xx, xy += b.xy, yy += b.yy;
    xxx += b.xxx, xxy += b.xxy, xyy += b.xyy, yyy += b.yyy;
    return *this;
  }
};

inline Jet3 operator+(Jet3 a, const Jet3& b) {
  return a += b;
}
inline Jet3 operator*(double c, const Jet3& a) {
  return {c * a.v,  c * a.x,   c * a.y,   c * a.xx,  c * a.xy,
          c * a.yy, c * a.xxx, c * a.xxy, c * a.xyy, c * a.yyy};
}
inline Jet3 operator-(const Jet3& a, const Jet3& b) {
  return a + -1.0 * b;
}
inline Jet3 operator*(const Jet3& a, const Jet3& b) {
  return {a.v * b.v,
          a.v * b.x + a.x * b.v,
          a.v * b.y + a.y * b.v,
          a.v * b.xx + 2 * (a.x * b.x) + a.xx * b.v,
          a.v * b.xy + a.x * b.y + a.y * b.x + a.xy * b.v,
          a.v * b.yy + 2 * (a.y * b.y) + a.yy * b.v,
          a.v * b.xxx + 3 * (a.x * b.xx + a.xx * b.x) + a.xxx * b.v,
          a.v * b.xxy + a.y * b.xx + a.xx * b.y + 2 * (a.x * b.xy + a.xy * b.x) + a.xxy * b.v,
          a.v * b.xyy + a.x * b.yy + a.yy * b.x + 2 * (a.y * b.xy + a.xy * b.y) + a.xyy * b.v,
          a.v * b.yyy + 3 * (a.y * b.yy + a.yy * b.y) + a.yyy * b.v};
}
inline Jet3 compose(const Derivatives& f, const Jet3& a) {
  return {f.v,
          f.d * a.x,
          f.d * a.y,
          f.dd * (a.x * a.x) + f.d * a.xx,
          f.dd * (a.x * a.y) + f.d * a.xy,
          f.dd * (a.y * a.y) + f.d * a.yy,
          f.ddd * (a.x * a.x * a.x) + 3 * f.dd * (a.x * a.xx) + f.d * a.xxx,
          f.ddd * (a.x * a.x * a.y) + f.dd * (a.xx * a.y + 2 * (a.x * a.xy)) + f.d * a.xxy,
          f.ddd * (a.x * a.y * a.y) + f.dd * (a.yy * a.x + 2 * (a.y * a.xy)) + f.d * a.xyy,
          f.ddd * (a.y * a.y * a.y) + 3 * f.dd * (a.y * a.yy) + f.d * a.yyy};
}

}  // namespace hariko

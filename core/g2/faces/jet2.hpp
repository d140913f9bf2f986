#pragma once

// Jet2: a function of two variables with its first and second derivatives at a point.

#include <cmath>

namespace hariko {

/// Value and derivatives of a function of one variable.
struct Derivatives {
  double v, d, dd, ddd;
};

/// Value, first and second derivatives of a function of two variables at a point.
struct Jet2 {
  double v = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  static Jet2 constant(double c) { return {c, 0, 0, 0, 0, 0}; }
  /// Linear function value + ax (x - x0) + ay (y - y0).
  static Jet2 linear(double value, double ax, double ay) { return {value, ax, ay, 0, 0, 0}; }

  Jet2& operator+=(const Jet2& b) {
    v += b.v, x += b.x, y += b.y, xx += b.xx, xy += b.xy, yy += b.yy;
    return *this;
  }
};

inline Jet2 operator+(Jet2 a, const Jet2& b) {
  return a += b;
}
inline Jet2 operator*(double c, const Jet2& a) {
  return {c * a.v, c * a.x, c * a.y, c * a.xx, c * a.xy, c * a.yy};
}
inline Jet2 operator-(const Jet2& a, const Jet2& b) {
  return {a.v - b.v, a.x - b.x, a.y - b.y, a.xx - b.xx, a.xy - b.xy, a.yy - b.yy};
}
inline Jet2 operator*(const Jet2& a, const Jet2& b) {
  return {a.v * b.v,
          a.v * b.x + a.x * b.v,
          a.v * b.y + a.y * b.v,
          a.v * b.xx + 2 * (a.x * b.x) + a.xx * b.v,
          a.v * b.xy + a.x * b.y + a.y * b.x + a.xy * b.v,
          a.v * b.yy + 2 * (a.y * b.y) + a.yy * b.v};
}
/// Composition f(a), from the derivatives of f at a.v.
inline Jet2 compose(const Derivatives& f, const Jet2& a) {
  return {f.v,
          f.d * a.x,
          f.d * a.y,
          f.dd * (a.x * a.x) + f.d * a.xx,
          f.dd * (a.x * a.y) + f.d * a.xy,
          f.dd * (a.y * a.y) + f.d * a.yy};
}
template <class Jet>
Jet reciprocal(const Jet& a) {
  const double r = 1 / a.v;
  return compose(Derivatives{r, -r * r, 2 * r * r * r, -6 * r * r * r * r}, a);
}
template <class Jet>
Jet square_root(const Jet& a) {
  const double r = std::sqrt(a.v), d = 0.5 / r;
  return compose(Derivatives{r, d, -0.5 * d / a.v, 0.75 * d / (a.v * a.v)}, a);
}
template <class Jet>
Jet cube(const Jet& a) {
  return compose(Derivatives{a.v * a.v * a.v, 3 * a.v * a.v, 6 * a.v, 6}, a);
}

}  // namespace hariko

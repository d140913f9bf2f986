#include "core/g2/faces/corner_side.hpp"

#include <cmath>

namespace hariko {

namespace {

/// Largest slant of a ribbon, in lengths of its side.
constexpr double largest_slant = 0.5;

/// Bounded slant u (1 + (u/limit)^4)^(-1/4): equal to u near zero, never beyond the limit. A ribbon's slant
/// must not grow with the distance from its side, since ribbons of long, slanting faces would be evaluated
/// far beyond their ends.
Derivatives bounded(double u) {
  const double square = largest_slant * largest_slant, k = 1 / (square * square);
  const double u2 = u * u, u3 = u2 * u, q = 1 + k * u2 * u2, root = 1 / std::sqrt(std::sqrt(q));
  const double first = root / q;
  return {u * root, first, -5 * k * u3 * (first / q),
          (-15 * k * u2 + 45 * k * k * u3 * u3 / q) * (first / q)};
}

/// Displacement of (x, y) when it is turned about 0 by `share` of its angle from the x axis, less `before`.
template <class Jet>
std::array<Jet, 2> turned_way(const Jet& x, const Jet& y, double share, double before) {
  const Jet half = y * reciprocal(square_root(x * x + y * y) + x);  // tangent of half of the angle
  const double k = 2 * share, q = half.v, w = 1 / (1 + q * q);
  const Jet angle = compose(
      Derivatives{k * std::atan(q) - before, k * w, -2 * k * q * w * w, k * (6 * q * q - 2) * w * w * w},
      half);
  const double c = std::cos(angle.v), s = std::sin(angle.v), sine_of_half = std::sin(0.5 * angle.v);
  const Jet cosine = compose(Derivatives{-2 * sine_of_half * sine_of_half, -s, -c, s}, angle);  // less 1
  const Jet sine = compose(Derivatives{s, c, -s, -c}, angle);
  return {cosine * x - sine * y, sine * x + cosine * y};
}

}  // namespace

template <class Jet>
CornerMap<Jet> CornerSide::unturned(const Vector2& from, bool limited) const {
  const Jet u = Jet::linear(along.dot(from), along.x(), along.y());
  const Jet v = Jet::linear(across.dot(from), across.x(), across.y());
  const Jet slanting = slant * v;
  const Jet t = u + (limited ? compose(bounded(slanting.v), slanting) : slanting), s = rise * v;
  if (bend_along == 0 && bend_across == 0) return {t, s};
  const Jet both = v * Jet::linear(other.dot(from), other.x(), other.y());
  return {t + bend_along * both, s + bend_across * both};
}
template CornerMap<Jet2> CornerSide::unturned(const Vector2&, bool) const;
template CornerMap<Jet3> CornerSide::unturned(const Vector2&, bool) const;

template <class Jet>
CornerMap<Jet> CornerSide::operator()(const Vector2& from) const {
  const CornerMap<Jet> at = unturned<Jet>(from, true);
  if (turn == 0) return at;
  const auto [x, y] = turned_way(length * at.t, unit * at.s, turn, 0.0);
  return {at.t + (1 / length) * x, at.s + (1 / unit) * y};
}
template CornerMap<Jet2> CornerSide::operator()(const Vector2&) const;
template CornerMap<Jet3> CornerSide::operator()(const Vector2&) const;

std::array<Jet3, 2> CornerSide::opening(const Vector2& from, double angle, double reach) const {
  const auto linear = [&](const Vector2& slope) {
    return Jet3::linear(slope.dot(from), slope.x(), slope.y());
  };
  const Jet3 x = linear(length * (along + slant * across)), y = linear(unit * rise * across);
  const Jet3 near = Jet3::constant(1) - (1 / (reach * reach)) * (x * x + y * y);
  if (!(near.v > 0)) return {Jet3{}, Jet3{}};
  const Jet3 fade = near * cube(near);
  const auto [dx, dy] = turned_way(x, y, turn, 0.5 * turn * angle);
  return {fade * dx, fade * dy};
}

}  // namespace hariko

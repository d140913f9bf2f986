#pragma once

// CornerWarp: parameters of a square in which a Catmull-Clark patch runs evenly into an extraordinary vertex.

#include "core/surface/surface.hpp"

namespace hariko {

/// Map of the unit square to itself that multiplies the distance r = u + v - u v from a corner to the power
/// `exponent`: (u, v) -> (u, v) r^(exponent - 1), u and v from that corner along both sides. The sides that
/// meet there keep their lines, and the two others all their points. Near an extraordinary vertex a
/// Catmull-Clark patch is homogeneous of degree log2(1 / lambda), lambda the subdominant eigenvalue of
/// subdivision there: with the reciprocal as exponent the patch becomes one of degree 1, which splines with
/// few knots follow. The map depends on the vertex alone, so that faces that share a side agree there.
class CornerWarp {
 public:
  /// `corner`: 0 .. 3, as of squares. `exponent` > 0.
  CornerWarp(int corner, double exponent);

  bool is_corner(const Vector2& at) const { return at.x() == corner_s_ && at.y() == corner_t_; }
  /// Image of a point of the square.
  Vector2 map(const Vector2& at) const;
  /// Derivatives by the square's parameters of a point with derivatives by the image's, at `map(at)`; second
  /// ones where `order` says so, else zero. `at` is not the corner itself, where they do not exist.
  PatchPoint pull_back(const PatchPoint& point, const Vector2& at, Order order) const;

 private:
  /// Parameters from the corner.
  Vector2 from_corner(const Vector2& at) const;

  double corner_s_, corner_t_, power_;
};

/// Exponent of the map at a vertex inside a smooth surface where this many patches meet, 3 or more; 1 for
/// four.
double warp_exponent(int valence);

}  // namespace hariko

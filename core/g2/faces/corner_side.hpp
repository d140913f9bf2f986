#pragma once

// Corner side: the map from a corner of a face's polygon to the chart of its vertex, in the coordinates of
// one of the corner's sides (g2.md section 4).

#include <array>

#include "core/base/vector.hpp"
#include "core/g2/faces/jet3.hpp"

namespace hariko {

/// Coordinates along a side, in sides, and across it.
template <class Jet>
struct CornerMap {
  Jet t, s;
};

/// Map of a corner beside one of its sides: t = along + slant * across, and s = rise * across, with terms of
/// second order of both; then a rotation about the corner in proportion to the angle from the side.
struct CornerSide {
  Vector2 along = Vector2::Zero(), across = Vector2::Zero();  ///< Gradients; across is a distance.
  double slant = 0, rise = 1;
  /// Terms of second order, by the product of the distances from both sides: the edges stay straight.
  double bend_along = 0, bend_across = 0;
  Vector2 other = Vector2::Zero();  ///< Gradient of the distance from the other side.
  double length = 1, unit = 1;      ///< Lengths of a unit of t and of s in the chart of the vertex.
  double turn = 0;                  ///< Rotation, as a share of the angle.

  /// Map without the rotation. `from`: place relative to the corner. `limited`: limits the slant.
  template <class Jet>
  CornerMap<Jet> unturned(const Vector2& from, bool limited) const;
  /// Map of a place relative to the corner, which is not its other side.
  template <class Jet>
  CornerMap<Jet> operator()(const Vector2& from) const;
  /// Way of a place in the vertex's chart when both sides, `angle` apart, are turned away from each other as
  /// far as the rotation would take them, and less so with the distance: not at all from `reach` on.
  std::array<Jet3, 2> opening(const Vector2& from, double angle, double reach) const;
};

}  // namespace hariko

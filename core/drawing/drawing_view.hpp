#pragma once

// View of a line drawing, as a value: the eye, its axes and the page.

#include <Eigen/Geometry>
#include <optional>

#include "core/base/vector.hpp"

namespace hariko {

/// Width of the strip round the page in which lines are still drawn, page units: wider than any pen, so that
/// pens are not cut off.
inline constexpr double page_margin = 4;

/// Projection from the world to the page. Page: x to the right, y down, from the upper left corner, in the
/// page's unit.
struct DrawingView {
  Vector3 eye = Vector3::Zero();
  Vector3 right = Vector3::UnitX(), up = Vector3::UnitY(), forward = -Vector3::UnitZ();  ///< unit, orthogonal
  bool orthographic = false;
  double focal = 1;   ///< page units per unit of slope, or per unit of length when orthographic; > 0
  double middle = 0;  ///< slope from the eye to the page's middle along `up`, in perspective
  double width = 1, height = 1;
  /// Least depth of what is drawn, a length; > 0 in perspective.
  double near_plane = 1e-6;
  /// Section plane; the side that its normal points to is cut away: normal . p + offset > 0.
  std::optional<Eigen::Hyperplane<double, 3>> section = {};

  /// Position on the page (x, y) and depth, the distance from the eye's plane.
  Vector3 project(const Vector3& p) const {
    const Vector3 d = p - eye;
    const double depth = d.dot(forward), scale = orthographic ? focal : focal / depth;
    return {width / 2 + scale * d.dot(right), height / 2 - scale * d.dot(up) + raise(), depth};
  }
  /// Page units by which the point straight ahead of the eye lies below the page's middle.
  double raise() const { return orthographic ? 0 : focal * middle; }
  /// Direction from a point to the eye; not a unit vector in perspective.
  Vector3 towards_eye(const Vector3& p) const { return orthographic ? Vector3(-forward) : Vector3(eye - p); }
  /// Whether a depth is beyond the near plane.
  bool in_front(double depth) const { return orthographic || depth > near_plane; }
};

}  // namespace hariko

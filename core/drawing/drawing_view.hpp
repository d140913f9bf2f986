#pragma once

// Where a line drawing is seen from: the eye, its axes and the page, as a value.

#include <Eigen/Geometry>
#include <optional>

#include "core/base/vector.hpp"

namespace hariko {

/// Units beside the page within which lines are drawn, so that pens are not cut off: wider than any.
inline constexpr double page_margin = 4;

/// World to page. Page: x to the right, y down, from the upper left corner, in the page's unit.
struct DrawingView {
  Vector3 eye = Vector3::Zero();
  Vector3 right = Vector3::UnitX(), up = Vector3::UnitY(), forward = -Vector3::UnitZ();  ///< unit, orthogonal
  bool orthographic = false;
  double focal = 1;  ///< page units per unit of slope, or per unit of length when orthographic; > 0
  double width = 1, height = 1;
  /// What lies closer to the eye's plane is not drawn, > 0 in perspective.
  double near_plane = 1e-6;
  /// Where the normal points to is cut away: normal . p > offset.
  std::optional<Eigen::Hyperplane<double, 3>> section = {};

  /// The place on the page, and the distance from the eye's plane.
  Vector3 project(const Vector3& p) const {
    const Vector3 d = p - eye;
    const double depth = d.dot(forward), scale = orthographic ? focal : focal / depth;
    return {width / 2 + scale * d.dot(right), height / 2 - scale * d.dot(up), depth};
  }
  /// From a point to the eye; not unit in perspective.
  Vector3 towards_eye(const Vector3& p) const { return orthographic ? Vector3(-forward) : Vector3(eye - p); }
  bool in_front(double depth) const { return orthographic || depth > near_plane; }
};

}  // namespace hariko

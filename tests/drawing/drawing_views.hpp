#pragma once

// Views for drawings of things round the origin.

#include <Eigen/Geometry>

#include "core/drawing/drawing_view.hpp"

namespace hariko::test {

/// Looks at `target` along `direction`; the page shows `height` length units at the target.
inline DrawingView view_along(const Vector3& direction, const Vector3& target, double distance, double height,
                              bool orthographic) {
  DrawingView view;
  view.forward = direction.normalized();
  view.right = view.forward.cross(Vector3(0.1, 0.2, 1)).normalized();
  view.up = view.right.cross(view.forward);
  view.eye = target - distance * view.forward;
  view.orthographic = orthographic;
  view.width = 800;
  view.height = 600;
  view.focal = orthographic ? view.height / height : view.height * distance / height;
  view.near_plane = 1e-3 * distance;
  return view;
}

}  // namespace hariko::test

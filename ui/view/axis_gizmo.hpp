#pragma once

// AxisGizmo: the balls in a view's corner that show where the axes point and look along them when clicked.

#include <imgui.h>

#include <array>
#include <optional>

#include "render/camera.hpp"
#include "ui/base/theme.hpp"

namespace hariko {

/// A snapshot for one frame: where the balls are for a camera.
class AxisGizmo {
 public:
  struct Ball {
    int axis = 0;  ///< 0 x, 1 y, 2 z
    bool positive = true;
    ImVec2 offset{0, 0};  ///< from the gizmo's middle, in radii, y down
    double depth = 0;     ///< -1 .. 1, greater is nearer to the viewer
  };

  /// `middle` and `radius` in window pixels.
  AxisGizmo(const Camera& camera, ImVec2 middle, float radius);

  /// Farthest first.
  const std::array<Ball, 6>& balls() const { return balls_; }
  ImVec2 centre_of(const Ball& ball) const;
  float ball_radius() const { return 0.21F * radius_; }
  bool holds(ImVec2 point) const;
  /// The side that a click looks from: that of the nearest ball under the point. A ball that faces the viewer
  /// already looks from the opposite side.
  std::optional<StandardView> side_at(ImVec2 point) const;
  /// `lit`: a disc shows that dragging turns the view.
  void draw(ImDrawList& list, std::optional<ImVec2> pointer, bool lit) const;

 private:
  const Ball* ball_at(ImVec2 point) const;

  ImVec2 middle_;
  float radius_;
  std::array<Ball, 6> balls_{};
};

/// The side of the world that a half axis points to: +x is right, +y is back.
StandardView side_of_axis(int axis, bool positive);

}  // namespace hariko

#include "ui/view/plane_grid.hpp"

#include <algorithm>
#include <cmath>

#include "ui/view/overlay_drawing.hpp"
#include "ui/view/snapping.hpp"

namespace hariko {

namespace {

constexpr int lines_each_way = 60;

/// A step whose lines are far enough from each other to be read, and how many make a stronger line.
double line_step(const ToolContext& context, const Vector3& point) {
  return grid_step(context, point).size();
}

void draw_line(const ToolOverlay& overlay, const Projector& projector, const Vector3& from, const Vector3& to,
               ImU32 colour, float width) {
  const auto a = projector.project(from), b = projector.project(to);
  if (!a || !b) return;
  overlay.list.AddLine(on_screen(overlay, a->head<2>()), on_screen(overlay, b->head<2>()), colour, width);
}

}  // namespace

void draw_plane_grid(const ToolContext& context, const ToolOverlay& overlay, const Vector3& point,
                     const Matrix3& axes) {
  const Projector projector = context.projector();
  const double step = line_step(context, point);
  const double reach = lines_each_way * step;
  const float thin = overlay.metrics.px(1);
  for (int axis = 0; axis < 2; ++axis) {
    const Vector3 along = reach * axes.col(axis), across = step * axes.col(1 - axis);
    for (int i = -lines_each_way; i <= lines_each_way; ++i) {
      if (i == 0) continue;
      const Vector3 middle = point + i * across;
      draw_line(overlay, projector, middle - along, middle + along,
                with_alpha(palette().dim_text, i % 10 == 0 ? 0.45F : 0.16F), thin);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
    draw_axis_line(overlay, projector, point, axes.col(axis), axis_colour(axis, 190));
  // Lengths at the stronger lines.
  for (int axis = 0; axis < 2; ++axis)
    for (int i = -lines_each_way; i <= lines_each_way; i += 10) {
      if (i == 0) continue;
      const auto at = projector.project(point + i * step * axes.col(axis));
      if (!at) continue;
      ImVec2 place = on_screen(overlay, at->head<2>());
      place.x += overlay.metrics.px(3), place.y += overlay.metrics.px(2);
      overlay.list.AddText(place, palette().dim_text, length_text(context.editor, i * step).c_str());
    }
}

}  // namespace hariko

#pragma once

// PlaneGrid: lines, axes and lengths in the plane that is drawn in.

#include "ui/view/tool.hpp"

namespace hariko {

/// Draws the decimal grid of a plane round a point, over the whole view, the two axes through the point in
/// their colours, and along them how far lines are from it. `axes`: the plane's in its first two columns.
void draw_plane_grid(const ToolContext& context, const ToolOverlay& overlay, const Vector3& point,
                     const Matrix3& axes);

}  // namespace hariko

#pragma once

// Drawing over the picture: what tools share. Positions are the tools' framebuffer pixels.

#include <span>
#include <string>

#include "ui/view/tool.hpp"

namespace hariko {

/// A framebuffer pixel of the viewport in ImGui's coordinates.
ImVec2 on_screen(const ToolOverlay& overlay, const Vector2& pixel);

/// A line of text on a dark plate beside a place, within the viewport. `warning` colours it.
void draw_value_label(const ToolOverlay& overlay, const Vector2& beside, const std::string& text,
                      bool warning = false);

/// The whole line through a point along a direction, as far as it can be seen.
void draw_axis_line(const ToolOverlay& overlay, const Projector& projector, const Vector3& through,
                    const Vector3& direction, ImU32 colour);

/// The line through points of the document's space; what lies behind the eye is left out.
void draw_polyline(const ToolOverlay& overlay, const Projector& projector, std::span<const Vector3> points,
                   ImU32 colour, float width);

void draw_dashed_line(const ToolOverlay& overlay, const Vector2& from, const Vector2& to, ImU32 colour);

/// At most so many decimals, without zeros at the end.
std::string fixed_text(double value, int decimals);
/// A length with its unit: three decimals after the size of the view.
std::string length_text(const Editor& editor, double length);

/// Draws the decimal grid of a plane round a point, over the whole view, the two axes through the point in
/// their colours, and along them how far lines are from it. `axes`: the plane's in its first two columns.
void draw_plane_grid(const ToolContext& context, const ToolOverlay& overlay, const Vector3& point,
                     const Matrix3& axes);

}  // namespace hariko

#pragma once

// Drawing over the picture: what tools share. Positions are the tools' framebuffer pixels.

#include <string>

#include "ui/view/tool.hpp"

namespace hariko {

/// Red, green and blue for the axes x, y and z.
ImU32 axis_colour(int axis, unsigned alpha = 255);

/// A framebuffer pixel of the viewport in ImGui's coordinates.
ImVec2 on_screen(const ToolOverlay& overlay, const Vector2& pixel);

/// A line of text on a dark plate beside a place, within the viewport. `warning` colours it.
void draw_value_label(const ToolOverlay& overlay, const Vector2& beside, const std::string& text,
                      bool warning = false);

/// The whole line through a point along a direction, as far as it can be seen.
void draw_axis_line(const ToolOverlay& overlay, const Projector& projector, const Vector3& through,
                    const Vector3& direction, ImU32 colour);

void draw_dashed_line(const ToolOverlay& overlay, const Vector2& from, const Vector2& to, ImU32 colour);

/// At most so many decimals, without zeros at the end.
std::string fixed_text(double value, int decimals);
/// A length with its unit: three decimals after the size of the view.
std::string length_text(const Editor& editor, double length);

}  // namespace hariko

#pragma once

#include <string>

#include "core/drawing/line_drawing.hpp"

namespace hariko {

/// The drawing as SVG 1.1 without a background: one layer a kind of stroke, hidden ones dashed in layers of
/// their own. Coordinates are rounded to a hundredth of the page's unit. Strokes that leave the page are cut
/// off by viewers. `unit` of width and height: "px", "mm".
std::string write_drawing_svg(const LineDrawing& drawing, std::string_view unit);

}  // namespace hariko

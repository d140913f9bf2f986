#pragma once

#include <cstdint>
#include <string>

#include "core/drawing/line_drawing.hpp"

namespace hariko {

/// In what the numbers of the file are; a pixel is 1/96 inch.
enum class PageUnit : std::uint8_t { pixel, millimetre };
inline constexpr double pixels_per_millimetre = 96 / 25.4;
inline constexpr double least_page_side = 10, most_page_side = 2000;  ///< mm, that make sense to ask for

/// A drawing whose page is in pixels as SVG 1.1 without a background: one layer a kind of line, hidden ones
/// dashed in layers of their own. Pens are 0.5, 0.35 and 0.18 mm wide, whatever the size of the page.
/// Coordinates are rounded to a hundredth of a pixel. Lines that leave the page are cut off by viewers.
std::string write_drawing_svg(const LineDrawing& drawing, PageUnit unit);

}  // namespace hariko

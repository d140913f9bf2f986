#pragma once

// Writer of line drawings as SVG.

#include <cstdint>
#include <string>

#include "core/drawing/line_drawing.hpp"

namespace hariko {

/// Unit of the numbers in a file; a pixel is 1/96 inch.
enum class PageUnit : std::uint8_t { pixel, millimetre };
/// Pixels in a millimetre.
inline constexpr double pixels_per_millimetre = 96 / 25.4;
inline constexpr double least_page_side = 10, most_page_side = 2000;  ///< sensible range, mm

/// SVG 1.1 of a drawing whose page is in pixels, without a background: one layer for each kind of line,
/// hidden lines dashed in layers of their own. Pens are 0.5, 0.35 and 0.18 mm wide, whatever the size of the
/// page. Coordinates are rounded to a hundredth of a pixel. Viewers clip lines at the page. O(points).
std::string write_drawing_svg(const LineDrawing& drawing, PageUnit unit);

}  // namespace hariko

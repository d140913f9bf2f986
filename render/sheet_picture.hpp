#pragma once

// Pictures of the pages of a paper model.

#include "core/unfolding/pages/sheet_drawing.hpp"
#include "render/image.hpp"

namespace hariko {

/// Resolution of 150 dots per inch, in dots per millimetre.
inline constexpr double sheet_dots = 150 / 25.4;

/// Resolution, dots per millimetre, limited so that the pages side by side have at most 40 million pixels; at
/// most `wanted`.
double sheet_resolution(const SheetDrawing& drawing, double wanted = sheet_dots);

/// Pages on white, side by side with `page_spacing` of grey between them, as in the SVG file. `dots` a
/// millimetre, above 0. O(pixels + length of the lines).
Image sheet_picture(const SheetDrawing& drawing, double dots);

}  // namespace hariko

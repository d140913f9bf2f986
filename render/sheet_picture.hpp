#pragma once

// Pictures of the pages of a paper model.

#include "core/unfolding/sheet_drawing.hpp"
#include "render/image.hpp"

namespace hariko {

/// 150 dots an inch.
inline constexpr double sheet_dots = 150 / 25.4;

/// Dots a millimetre at which the pages, side by side, are at most `wanted` and 40 million pixels.
double sheet_resolution(const SheetDrawing& drawing, double wanted = sheet_dots);

/// The pages on white, side by side with `page_spacing` of grey between them, as in the SVG file. `dots` a
/// millimetre, above 0. O(pixels + length of the lines).
Image sheet_picture(const SheetDrawing& drawing, double dots);

}  // namespace hariko

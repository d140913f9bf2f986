#pragma once

// Dot text: letters of 5 by 8 dots, as displays have them, for machines on which no font can be found.
// Internal to render/.

#include <string_view>

#include "core/base/vector.hpp"
#include "render/image.hpp"

namespace hariko {

/// Width in pixels of text at a size in pixels (of the em).
double dot_text_width(std::u32string_view text, double size);

/// Paints text with the baseline's left end at `start`; `angle` is counter-clockwise, in radians. Characters
/// without dots are boxes. O(pixels of the text's bounds).
void paint_dot_text(Image& image, std::u32string_view text, const Vector2& start, double angle, double size,
                    const Color& color);

}  // namespace hariko

#pragma once

// Legend of a colour map, painted into pictures. The window paints its own from the same ranges and ticks.

#include <optional>
#include <string>
#include <vector>

#include "render/color_map.hpp"
#include "render/font_files.hpp"
#include "render/image.hpp"

namespace hariko {

/// Content and look of a legend.
struct Legend {
  SurfaceMap map = SurfaceMap::gaussian;
  ValueRange range;              ///< its centre is the limit of maps that have one
  std::string unit;              ///< as from `unit_of`
  std::vector<float> histogram;  ///< drawn beside the bar unless empty
  bool on_dark = true;           ///< light text for dark backgrounds
  double scale = 1;              ///< pixels per design pixel
  bool colour_blind_safe = false;
};

/// Width of a legend at the left of a picture, design pixels.
inline constexpr int legend_width = 180;

/// Paints a legend at the lower left, with a font as `TextPainter` takes it.
void paint_legend(Image& image, const Legend& legend,
                  const std::optional<FontFile>& font = font_files().text);

}  // namespace hariko

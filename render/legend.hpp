#pragma once

// Legend of a colour map, painted into pictures. The window paints its own from the same ranges and ticks.

#include <string>

#include "render/color_map.hpp"
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

/// Paints a legend at the lower left. Text needs an installed font (Inter, Noto or DejaVu Sans); without one
/// only the bar and tick marks are painted and the result is false.
bool paint_legend(Image& image, const Legend& legend);

}  // namespace hariko

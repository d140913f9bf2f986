#pragma once

// Legend: the bar that says which colour means which value, painted into pictures. The window paints its own
// from the same ranges and ticks.

#include <string>

#include "render/color_map.hpp"
#include "render/image.hpp"

namespace hariko {

struct Legend {
  SurfaceMap map = SurfaceMap::gaussian;
  ValueRange range;
  std::string unit;              ///< as from unit_of
  std::vector<float> histogram;  ///< drawn beside the bar when not empty
  bool on_dark = true;           ///< colour of text
  double scale = 1;              ///< pixels per design pixel
  bool colour_blind_safe = false;
};

/// Room that a legend takes at the left, in design pixels.
inline constexpr int legend_width = 180;

/// Paints the legend at the lower left. Text needs an installed font (Inter, Noto or DejaVu Sans); without
/// one only the bar and tick marks are painted and the result is false.
bool paint_legend(Image& image, const Legend& legend);

}  // namespace hariko

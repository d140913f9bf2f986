#pragma once

// Sliders with their number beside the track, where the grab does not cover it.

#include <imgui.h>

namespace hariko {

/// Values of a slider, and how its number is written, as printf does ("%.2f mm").
struct SliderRange {
  double low, high;
  const char* format;
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
};

/// A slider over `width` pixels, or over the rest of the row, with its number at the right end. Ctrl and a
/// click make the track a field. True when the value changed. The last item then is the track; what follows
/// in the row stands behind the number.
bool number_slider(const char* id, const SliderRange& range, double& value, float width = -1);
/// Likewise for whole numbers ("%d").
bool number_slider(const char* id, const SliderRange& range, int& value, float width = -1);

}  // namespace hariko

#pragma once

// Theme: colours by role and spacing of the interface.

#include <imgui.h>

namespace hariko {

/// Colours by what they are for, sRGB as ImGui wants them.
struct Palette {
  ImU32 window, panel, field, field_hover, separator;
  ImU32 text, dim_text, accent, secondary, error, warning, good;
};
const Palette& palette();

/// Sizes in pixels, already scaled.
struct Metrics {
  float scale = 1;
  float px(float design_pixels) const { return design_pixels * scale; }
};

/// Sets the style. `scale` is framebuffer pixels per design pixel.
void apply_theme(float scale);

/// A scoped text colour.
class TextColour {
 public:
  explicit TextColour(ImU32 colour) { ImGui::PushStyleColor(ImGuiCol_Text, colour); }
  ~TextColour() { ImGui::PopStyleColor(); }
  TextColour(const TextColour&) = delete;
  TextColour& operator=(const TextColour&) = delete;
};

}  // namespace hariko

#pragma once

// Theme: colours by role, fonts and spacing of the interface.

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

/// Loads Inter and the icon font (or the built-in font where files are missing: the result then says which)
/// and sets the style. Call once, after the ImGui context exists. `scale` is framebuffer pixels per design
/// pixel.
const char* apply_theme(float scale);

/// The large font of the start page's title.
ImFont* title_font();

/// A scoped text colour.
class TextColour {
 public:
  explicit TextColour(ImU32 colour) { ImGui::PushStyleColor(ImGuiCol_Text, colour); }
  ~TextColour() { ImGui::PopStyleColor(); }
  TextColour(const TextColour&) = delete;
  TextColour& operator=(const TextColour&) = delete;
};

}  // namespace hariko

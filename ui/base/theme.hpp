#pragma once

// Theme: colours by role and spacing of the interface.

#include <imgui.h>

#include "ui/base/settings.hpp"

namespace hariko {

/// Colours by what they are for, sRGB as ImGui wants them. Text roles (text, dim_text, accent, secondary,
/// error, warning, good) are readable on window, panel, popup and field; a test holds them to a contrast
/// of 4.5 : 1.
struct Palette {
  ImU32 window, panel, popup, field, field_hover, field_active, separator;
  ImU32 text, dim_text, accent, secondary, error, warning, good;
  ImU32 accent_hover, on_accent;  ///< a filled button under the pointer; text on it
  ImU32 hot;      ///< over the picture: the handle under the pointer, places that attract, lines to be cut
  ImU32 handle;   ///< sliders and scroll bars
  ImU32 shade;    ///< over the window behind a dialog
  ImU32 overlay;  ///< behind text over the picture, translucent
};

Palette palette_of(ThemeId theme);

/// The palette in use: it belongs to ImGui's context, as the style does (see `apply_theme`).
const Palette& palette();

/// Red, green and blue for the axes x, y and z.
ImU32 axis_colour(int axis, unsigned alpha = 0xff);

/// A colour with another opacity, 0 .. 1.
ImU32 with_alpha(ImU32 colour, float alpha);

/// Contrast of two opaque colours by WCAG 2, 1 .. 21.
double contrast(ImU32 a, ImU32 b);

/// Sizes in pixels, already scaled.
struct Metrics {
  float scale = 1;
  float px(float design_pixels) const { return design_pixels * scale; }
};

/// Sets colours and sizes of ImGui's context; `scale` is framebuffer pixels per design pixel. `in_use`
/// becomes the palette of the theme and must live as long as the context, to which it is tied.
void apply_theme(ThemeId theme, float scale, Palette& in_use);

/// A scoped text colour.
class TextColour {
 public:
  explicit TextColour(ImU32 colour) { ImGui::PushStyleColor(ImGuiCol_Text, colour); }
  ~TextColour() { ImGui::PopStyleColor(); }
  TextColour(const TextColour&) = delete;
  TextColour& operator=(const TextColour&) = delete;
};

}  // namespace hariko

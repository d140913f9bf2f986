#pragma once

// Sliders with their number beside the track, where the grab does not cover it, and numbers that are typed or
// dragged, of what is no part of the document.

#include <imgui.h>

#include <string>

namespace hariko {

class Marks;
struct PanelContext;

constexpr float number_field_width = 78;  ///< width of a field beside a slider, design pixels

/// Values of a slider, and how its number is written, as printf does ("%.2f mm").
struct SliderRange {
  double low, high;
  const char* format;
  ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
  float room = 0;  ///< least room for the number, pixels: tracks below each other are then equally long
};

/// A slider over `width` pixels, or over the rest of the row, with its number at the right end. Ctrl and a
/// click make the track a field. True when the value changed. The last item then is the track; what follows
/// in the row stands behind the number. Numbers here are double, or int ("%d").
template <class Number>
bool number_slider(Marks& marks, const std::string& mark, const SliderRange& range, Number& value,
                   float width = -1);

/// A row of a panel with a slider of what is no part of the document, so without steps; label and help are
/// English. A value that is no number is not taken. Mark: "slider.<id>".
template <class Number>
void slider_row(PanelContext& context, const std::string& id, const char* label, const char* help,
                const SliderRange& range, Number& value);

/// A number that is typed, of a width in pixels; one outside of the range becomes its end, and what is no
/// number is not taken. True when it changed.
template <class Number>
bool number_input(Marks& marks, const std::string& mark, float width, const SliderRange& range,
                  Number& value);
/// A number over the rest of the row that is typed likewise, or dragged by `step` for each pixel.
bool number_drag(Marks& marks, const std::string& mark, const SliderRange& range, double step, double& value);

/// A track alone from 0 to `most`, float or int, of a width in pixels. True when it was moved.
template <class Number>
bool track_slider(Marks& marks, const std::string& mark, float width, Number most, Number& value);

}  // namespace hariko

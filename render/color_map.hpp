#pragma once

// Colour maps, value ranges and legend ticks, as pure functions. Shader tables, panels and pictures share
// them.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/display.hpp"
#include "core/document/making.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// Colour in sRGB, 0 .. 1.
struct Color {
  float r = 0, g = 0, b = 0, a = 1;
  friend bool operator==(const Color&, const Color&) = default;
};
/// Colour by "#b9b4ac" or "#b9b4acff", a constant of the program; asserts on anything else.
Color color_from_hex(std::string_view hex);

/// Colour of a document as floats.
Color color_of(const Colour& colour);

/// Map by the command line's words shaded|patches|zebra|gauss|mean|k1|k2|continuity|isophotes|draft|radius|
/// thickness|deviation; nothing for other words.
std::optional<SurfaceMap> surface_map_from(std::string_view word);
/// Those words, in the order of the maps.
std::vector<std::string> surface_map_words();
/// Inverse of `surface_map_from`.
std::string_view word_of(SurfaceMap map);
/// Title of a map for legends and menus: "Gaussian curvature" and so on.
std::string_view title_of(SurfaceMap map);
/// Whether a map colours by value and so has a range and a legend.
bool has_values(SurfaceMap map);
/// Unit of a map's values in a document with this unit of length: "mm", "1/mm", "1/mm²", or "°"; empty for
/// pure numbers.
std::string unit_of(SurfaceMap map, std::string_view length_unit);

/// Colour scales. Diverging: blue, white at the middle, red (safe: orange). Sequential: dark to light with
/// monotone lightness (safe: blue to yellow through grey). Limit: red (safe: orange) below the middle, which
/// is a fault, and white to blue above it, with a step between them. The safe ones are readable with every
/// kind of colour vision.
enum class ColorScale { diverging, sequential, limit, diverging_safe, sequential_safe, limit_safe };
inline constexpr int color_scale_count = 6;
/// Usual scale of a map.
ColorScale scale_of(SurfaceMap map);

/// Colour at x, clamped to [0, 1].
Color color_at(ColorScale scale, double x);
/// Lookup table with 256 RGBA entries, entry i at x = i / 255.
std::array<std::uint8_t, 256 * 4> color_table(ColorScale scale);
/// Colour of points where a map is undefined.
inline constexpr Color undefined_color{0.50F, 0.50F, 0.50F, 1.0F};
/// Colour of continuity marks on edges; they also differ in dashes and width.
Color mark_color(Continuity continuity);

/// Interval of map values.
struct ValueRange {
  double low = 0, high = 1;
  double centre = 0;  ///< value in the middle of diverging scales: zero, or the limit of a map that has one
  /// Position of a value in the range, not clamped; 1/2 for an empty range.
  double fraction(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// Scale for a map over a range: that of limits for maps with one, else diverging only where zero lies inside
/// the range, so that white is always zero.
ColorScale scale_for(SurfaceMap map, ValueRange range, bool colour_blind_safe);
/// Position of a value on a scale, not clamped. On diverging scales and those of limits the range's centre is
/// at 1/2 and both parts of the range reach their end; otherwise the range maps to 0 .. 1.
double scale_fraction(ColorScale scale, ValueRange range, double value);
/// Coefficients of `scale_fraction` for shaders: fraction = place + (value - pivot) * (value < pivot ? below
/// : above).
struct ScaleSlopes {
  double pivot = 0, place = 0, below = 0, above = 0;
};
/// Coefficients for a scale over a range.
ScaleSlopes scale_slopes(ColorScale scale, ValueRange range);

/// Values of a map below which it has one colour of its own, whatever its range: undercuts of drafts.
struct MapFloor {
  double value = 0;
  Color color;
};
std::optional<MapFloor> floor_of(SurfaceMap map, bool colour_blind_safe);
/// Colour of a value, as pictures and legends show it.
Color color_of_value(SurfaceMap map, ValueRange range, bool colour_blind_safe, double value);

/// Least and greatest value; {0, 1} without values. NaN and infinite values are ignored, here and below.
ValueRange full_range(std::span<const float> values);
/// Range from the `fraction` quantile to the 1 - fraction quantile (0 <= fraction < 0.5). O(n).
ValueRange percentile_range(std::span<const float> values, double fraction);
/// Smallest range [-m, m] that contains `range`.
ValueRange symmetric(ValueRange range);
/// Default range of a map: between its 2 % quantiles, symmetric about zero for diverging maps, from zero for
/// sequential ones, widened to round end numbers. Of maps with a limit the same distance on both sides of it,
/// whatever the values are: lengths from 0, drafts to three times the limit. Never empty. O(values).
ValueRange automatic_range(SurfaceMap map, std::span<const float> values, double limit = 0);

/// Range according to the settings, with the limit of the map as its centre. Never empty. O(values).
ValueRange value_range(SurfaceMap map, const MapRange& settings, std::span<const float> values,
                       double limit = 0);

/// Tick of a legend.
struct Tick {
  double value = 0;
  double fraction = 0;  ///< position in the range, in [0, 1]
  std::string label;
};
/// Ticks of a legend: at least `count` (>= 2) where the range begins and ends at round numbers, at multiples
/// of 1, 2, 2.5 or 5 times a power of ten within the range. Labels have just enough digits and the same
/// number of decimals; zero is "0", minus signs are U+2212.
std::vector<Tick> legend_ticks(ValueRange range, int count = 5);
/// Number to `digits` significant digits, locale-independent, with U+2212 as minus.
std::string format_number(double value, int digits = 4);

/// Histogram: share of the values in each of `bins` equal parts of the range, scaled so that the largest is
/// 1. Values outside the range are not counted.
std::vector<float> histogram(std::span<const float> values, ValueRange range, int bins);

}  // namespace hariko

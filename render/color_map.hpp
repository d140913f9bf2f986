#pragma once

// Colour maps, value ranges and legend ticks: pure functions, used by the shaders' tables, the panels and
// pictures.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/display.hpp"
#include "core/surface/surface.hpp"

namespace hariko {

/// sRGB, 0 .. 1.
struct Color {
  float r = 0, g = 0, b = 0, a = 1;
  friend bool operator==(const Color&, const Color&) = default;
};
/// "#b9b4ac" or "#b9b4acff"; a programmer's constant, asserts on anything else.
Color color_from_hex(std::string_view hex);

Color color_of(const Colour& colour);

/// From the command line's words shaded|patches|zebra|gauss|mean|k1|k2|continuity|isophotes; nothing for
/// other words.
std::optional<SurfaceMap> surface_map_from(std::string_view word);
/// The word back.
std::string_view word_of(SurfaceMap map);
/// "Gaussian curvature" and so on, for legends and menus.
std::string_view title_of(SurfaceMap map);
/// True for maps that colour by value and so have a range and a legend.
bool has_values(SurfaceMap map);
/// Unit of a map's values in a document with this unit of length: "1/mm", "1/mm²"; empty for pure numbers.
std::string unit_of(SurfaceMap map, std::string_view length_unit);

/// Diverging: blue, white at the middle, red (safe: orange). Sequential: dark to light with monotone
/// lightness (safe: blue to yellow through grey). The safe ones read the same to all kinds of colour vision.
enum class ColorScale { diverging, sequential, diverging_safe, sequential_safe };
inline constexpr int color_scale_count = 4;
ColorScale scale_of(SurfaceMap map);

/// Colour at x, clamped to [0, 1].
Color color_at(ColorScale scale, double x);
/// 256 RGBA entries for a lookup texture, entry i at x = i / 255.
std::array<std::uint8_t, 256 * 4> color_table(ColorScale scale);
inline constexpr Color undefined_color{0.50F, 0.50F, 0.50F, 1.0F};
/// Colour of the marks of edges with this continuity; they differ in dashes and width too.
Color mark_color(Continuity continuity);

struct ValueRange {
  double low = 0, high = 1;
  double fraction(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
  friend bool operator==(const ValueRange&, const ValueRange&) = default;
};

/// The scale for a map shown over a range: diverging only where zero lies inside, so that white is always
/// zero.
ColorScale scale_for(SurfaceMap map, ValueRange range, bool colour_blind_safe);
/// Place of a value in the colours of a scale, not clamped: on diverging scales zero is at 1/2 and both parts
/// of the range reach their end, elsewhere the range is 0 .. 1.
double scale_fraction(ColorScale scale, ValueRange range, double value);
/// The same as numbers for the shaders: fraction = place + (value - pivot) * (value < pivot ? below : above).
struct ScaleSlopes {
  double pivot = 0, place = 0, below = 0, above = 0;
};
ScaleSlopes scale_slopes(ColorScale scale, ValueRange range);

/// Least and greatest value; {0, 1} of nothing. NaN and infinite values are ignored, here and below.
ValueRange full_range(std::span<const float> values);
/// From the `fraction` quantile to the 1 - fraction quantile (0 <= fraction < 0.5). O(n).
ValueRange percentile_range(std::span<const float> values, double fraction);
/// The smallest range [-m, m] that holds `range`.
ValueRange symmetric(ValueRange range);
/// The range a map shows by default: 2 % quantiles; symmetric about zero for diverging maps, from zero for
/// sequential ones, widened to nice end numbers. Never empty.
ValueRange automatic_range(SurfaceMap map, std::span<const float> values);

/// The range that the settings ask for. Never empty. O(values).
ValueRange value_range(SurfaceMap map, const MapRange& settings, std::span<const float> values);

struct Tick {
  double value = 0;
  double fraction = 0;  ///< of the range, in [0, 1]
  std::string label;
};
/// At least `count` (>= 2) ticks, where the range begins and ends at round numbers, at 1, 2, 2.5 or 5 times a
/// power of ten within the range, labels with just enough digits, the same number of decimals each; zero is
/// "0", minus signs are U+2212.
std::vector<Tick> legend_ticks(ValueRange range, int count = 5);
/// A number to `digits` significant digits, locale-independent, with U+2212 as minus.
std::string format_number(double value, int digits = 4);

/// Share of the values in each of `bins` equal parts of the range, scaled so that the largest is 1. Values
/// outside the range are not counted.
std::vector<float> histogram(std::span<const float> values, ValueRange range, int bins);

}  // namespace hariko

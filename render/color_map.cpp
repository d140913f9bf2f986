#include "render/color_map.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/base/assert.hpp"

namespace hariko {

namespace {

struct MapFacts {
  SurfaceMap map;
  std::string_view word, title;
  int length_power;  ///< power of the length unit; 0 for pure numbers, angles and maps without values
};
constexpr std::array<MapFacts, surface_map_count> facts{{
    {SurfaceMap::shaded, "shaded", "Shaded", 0},
    {SurfaceMap::patches, "patches", "Patches", 0},
    {SurfaceMap::zebra, "zebra", "Zebra stripes", 0},
    {SurfaceMap::gaussian, "gauss", "Gaussian curvature", -2},
    {SurfaceMap::mean, "mean", "Mean curvature", -1},
    {SurfaceMap::principal_max, "k1", "Greatest curvature", -1},
    {SurfaceMap::principal_min, "k2", "Least curvature", -1},
    {SurfaceMap::continuity, "continuity", "Relative curvature jump", 0},
    {SurfaceMap::isophotes, "isophotes", "Isophotes", 0},
    {SurfaceMap::draft, "draft", "Draft angle", 0},
    {SurfaceMap::radius, "radius", "Smallest radius", 1},
    {SurfaceMap::thickness, "thickness", "Wall thickness", 1},
    {SurfaceMap::deviation, "deviation", "Deviation", 1},
}};

const MapFacts& facts_of(SurfaceMap map) {
  for (const MapFacts& fact : facts)
    if (fact.map == map) return fact;
  HARIKO_ASSERT(false, "unknown map");
  return facts[0];
}

float from_linear(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

/// Colour in polar Oklab (Ottosson 2020), which is perceptually uniform. Lightness 0 .. 1, chroma about 0 ..
/// 0.3, hue in degrees.
struct Polar {
  double lightness, chroma, hue;
};

Color from_oklab(double lightness, double a, double b) {
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return {from_linear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          from_linear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          from_linear(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), 1};
}

Color mix_oklab(const Polar& p, const Polar& q, double x) {
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  const double pa = p.chroma * std::cos(radians(p.hue)), pb = p.chroma * std::sin(radians(p.hue));
  const double qa = q.chroma * std::cos(radians(q.hue)), qb = q.chroma * std::sin(radians(q.hue));
  return from_oklab(p.lightness + x * (q.lightness - p.lightness), pa + x * (qa - pa), pb + x * (qb - pb));
}

// Sequential stops: lightness grows by equal steps; chroma stays inside the sRGB gamut.
constexpr std::array<Polar, 7> sequential_stops{{{0.26, 0.100, 305},
                                                 {0.37, 0.125, 282},
                                                 {0.48, 0.110, 245},
                                                 {0.59, 0.100, 200},
                                                 {0.70, 0.135, 158},
                                                 {0.81, 0.170, 128},
                                                 {0.92, 0.180, 103}}};
// Diverging ends have equal lightness, so that equal magnitudes look equally strong.
constexpr Polar blue_end{0.45, 0.165, 262}, white_middle{0.985, 0.0, 0}, red_end{0.45, 0.165, 25};
constexpr Polar blue_half{0.72, 0.110, 252}, red_half{0.72, 0.120, 35};

// Blue and orange differ for every kind of colour vision; lightness carries the magnitude.
constexpr Polar orange_end{0.52, 0.145, 58}, orange_half{0.77, 0.115, 68};
// Right below a limit a colour already: the step shows where the limit is.
constexpr Polar red_step{0.86, 0.075, 40}, orange_step{0.88, 0.085, 75}, blue_step{0.97, 0.012, 250};
constexpr std::array<Polar, 7> safe_sequential_stops{{{0.24, 0.085, 262},
                                                      {0.35, 0.075, 262},
                                                      {0.46, 0.035, 262},
                                                      {0.57, 0.025, 95},
                                                      {0.69, 0.065, 95},
                                                      {0.81, 0.115, 98},
                                                      {0.93, 0.165, 102}}};

bool is_of_limits(ColorScale scale) {
  return scale == ColorScale::limit || scale == ColorScale::limit_safe;
}

/// Colour at 0 .. 1 of the scales of limits: red or orange below the middle, white to blue from there on.
Color limit_color(double x, bool safe) {
  const double away = std::abs(2 * x - 1);
  const Polar& step = x < 0.5 ? (safe ? orange_step : red_step) : blue_step;
  const Polar& half = x < 0.5 ? (safe ? orange_half : red_half) : blue_half;
  const Polar& end = x < 0.5 ? (safe ? orange_end : red_end) : blue_end;
  return away <= 0.5 ? mix_oklab(step, half, 2 * away) : mix_oklab(half, end, 2 * away - 1);
}

/// Ends of the automatic range of a map with a limit.
ValueRange range_round(SurfaceMap map, double limit) {
  if (map != SurfaceMap::draft) return {0, limit > 0 ? 2 * limit : 1.0, limit};
  constexpr double usual = 5, right_angle = 90;  // degrees
  const double reach = std::min(limit > 0 ? 2 * limit : usual, right_angle - limit);
  return {limit - reach, limit + reach, limit};
}

std::vector<float> finite_values(std::span<const float> values) {
  std::vector<float> out;
  out.reserve(values.size());
  for (const float value : values)
    if (std::isfinite(value)) out.push_back(value);
  return out;
}

/// Spacing of ticks: factor * 10^exponent.
struct TickStep {
  double factor = 1;
  int exponent = 0;
  double length() const { return factor * std::pow(10.0, exponent); }
  int decimals() const { return std::max(0, -exponent + (factor == 2.5 ? 1 : 0)); }
};

/// Largest spacing that gives at least `count` ticks, or a smaller one that meets both ends of the range with
/// fewer than twice as many.
TickStep tick_step(ValueRange range, int count) {
  const double extent = range.high - range.low, most = extent / (count - 1) * (1 + 1e-9);
  const auto meets = [](double end, double step) {
    return std::abs(end / step - std::round(end / step)) < 1e-6;
  };
  const int top = static_cast<int>(std::floor(std::log10(most)));
  std::optional<TickStep> fallback;
  for (int exponent = top; exponent >= top - 1; --exponent)
    for (const double factor : {5.0, 2.5, 2.0, 1.0}) {
      const TickStep step{factor, exponent};
      if (step.length() > most) continue;
      if (!fallback && factor != 2.5) fallback = step;
      if (extent / step.length() + 1 < 2 * count && meets(range.low, step.length()) &&
          meets(range.high, step.length()))
        return step;
    }
  return *fallback;
}

/// Smallest round number that is not below `raw`.
double nice_end(double raw) {
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (raw <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

void use_real_minus(std::string& text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, "\u2212");
}

}  // namespace

Color color_from_hex(std::string_view hex) {
  HARIKO_ASSERT(hex.size() == 7 || hex.size() == 9, "a colour is #rrggbb or #rrggbbaa");
  std::array<float, 4> parts{0, 0, 0, 1};
  for (std::size_t i = 0; 2 * i + 2 < hex.size(); ++i) {
    unsigned value = 0;
    const char* begin = hex.data() + 1 + 2 * i;
    const auto [end, error] = std::from_chars(begin, begin + 2, value, 16);
    HARIKO_ASSERT(error == std::errc{} && end == begin + 2, "a colour is #rrggbb or #rrggbbaa");
    parts[i] = static_cast<float>(value) / 255.0F;
  }
  return {parts[0], parts[1], parts[2], parts[3]};
}

Color color_of(const Colour& colour) {
  const auto part = [](std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; };
  return {part(colour.red), part(colour.green), part(colour.blue), 1};
}

Color mark_color(Continuity continuity) {
  switch (continuity) {
    case Continuity::g0:
      return color_from_hex("#e0393e");
    case Continuity::g1:
      return color_from_hex("#f2b01e");
    case Continuity::g2:
      break;
  }
  return color_from_hex("#2f9bd8");
}

std::optional<SurfaceMap> surface_map_from(std::string_view word) {
  for (const MapFacts& fact : facts)
    if (fact.word == word) return fact.map;
  return std::nullopt;
}
std::vector<std::string> surface_map_words() {
  std::vector<std::string> out;
  for (const MapFacts& fact : facts) out.emplace_back(fact.word);
  return out;
}
std::string_view word_of(SurfaceMap map) {
  return facts_of(map).word;
}
std::string_view title_of(SurfaceMap map) {
  return facts_of(map).title;
}
bool has_values(SurfaceMap map) {
  return map == SurfaceMap::continuity || map == SurfaceMap::draft || facts_of(map).length_power != 0;
}

std::string unit_of(SurfaceMap map, std::string_view length_unit) {
  if (map == SurfaceMap::draft) return "\u00b0";
  const int power = facts_of(map).length_power;
  if (power == 0 || length_unit.empty()) return {};
  if (power == 1) return std::string(length_unit);
  return "1/" + std::string(length_unit) + (power == -2 ? "\u00b2" : "");
}

ColorScale scale_of(SurfaceMap map) {
  if (has_limit(map)) return ColorScale::limit;
  return map == SurfaceMap::continuity ? ColorScale::sequential : ColorScale::diverging;
}

ColorScale scale_for(SurfaceMap map, ValueRange range, bool colour_blind_safe) {
  if (has_limit(map)) return colour_blind_safe ? ColorScale::limit_safe : ColorScale::limit;
  const bool diverging = scale_of(map) == ColorScale::diverging && range.low < 0 && range.high > 0;
  if (diverging) return colour_blind_safe ? ColorScale::diverging_safe : ColorScale::diverging;
  return colour_blind_safe ? ColorScale::sequential_safe : ColorScale::sequential;
}

ScaleSlopes scale_slopes(ColorScale scale, ValueRange range) {
  const bool diverging = scale == ColorScale::diverging || scale == ColorScale::diverging_safe;
  const double under = range.centre - range.low, over = range.high - range.centre;
  if (diverging && under > 0 && over > 0) return {range.centre, 0.5, 0.5 / under, 0.5 / over};
  if (is_of_limits(scale))
    return {range.centre, 0.5, under > 0 ? 0.5 / under : 0.0, over > 0 ? 0.5 / over : 0.0};
  const double extent = range.high - range.low, slope = extent > 0 ? 1 / extent : 0;
  return {range.low, extent > 0 ? 0.0 : 0.5, slope, slope};
}

double scale_fraction(ColorScale scale, ValueRange range, double value) {
  const ScaleSlopes s = scale_slopes(scale, range);
  return s.place + (value - s.pivot) * (value < s.pivot ? s.below : s.above);
}

std::optional<MapFloor> floor_of(SurfaceMap map, bool colour_blind_safe) {
  if (map != SurfaceMap::draft) return std::nullopt;
  // Violet beside red and blue; without red, nearly black.
  return MapFloor{0, color_from_hex(colour_blind_safe ? "#23232b" : "#7b2d9e")};
}

Color color_of_value(SurfaceMap map, ValueRange range, bool colour_blind_safe, double value) {
  if (const auto floor = floor_of(map, colour_blind_safe); floor && value < floor->value) return floor->color;
  const ColorScale scale = scale_for(map, range, colour_blind_safe);
  return color_at(scale, scale_fraction(scale, range, value));
}

Color color_at(ColorScale scale, double x) {
  x = std::clamp(x, 0.0, 1.0);
  if (is_of_limits(scale)) return limit_color(x, scale == ColorScale::limit_safe);
  if (scale == ColorScale::sequential || scale == ColorScale::sequential_safe) {
    const auto& stops = scale == ColorScale::sequential ? sequential_stops : safe_sequential_stops;
    const double at = x * static_cast<double>(stops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    return mix_oklab(stops[i], stops[i + 1], at - static_cast<double>(i));
  }
  const double magnitude = std::abs(2 * x - 1);
  const bool safe = scale == ColorScale::diverging_safe;
  const Polar& half = x < 0.5 ? blue_half : (safe ? orange_half : red_half);
  if (magnitude <= 0.5) return mix_oklab(white_middle, half, 2 * magnitude);
  return mix_oklab(half, x < 0.5 ? blue_end : (safe ? orange_end : red_end), 2 * magnitude - 1);
}

std::array<std::uint8_t, 256 * 4> color_table(ColorScale scale) {
  std::array<std::uint8_t, 256 * 4> out{};
  const auto byte = [](float x) { return static_cast<std::uint8_t>(std::lround(x * 255.0F)); };
  for (std::size_t i = 0; i < 256; ++i) {
    const Color color = color_at(scale, static_cast<double>(i) / 255);
    out[4 * i] = byte(color.r);
    out[4 * i + 1] = byte(color.g);
    out[4 * i + 2] = byte(color.b);
    out[4 * i + 3] = 255;
  }
  return out;
}

ValueRange full_range(std::span<const float> values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, static_cast<double>(value));
    high = std::max(high, static_cast<double>(value));
  }
  return low <= high ? ValueRange{low, high} : ValueRange{};
}

ValueRange percentile_range(std::span<const float> values, double fraction) {
  HARIKO_ASSERT(fraction >= 0 && fraction < 0.5, "a quantile fraction lies in [0, 0.5)");
  std::vector<float> finite = finite_values(values);
  if (finite.empty()) return {};
  const auto at = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(finite.size()));
  std::nth_element(finite.begin(), finite.begin() + at, finite.end());
  const double low = finite[static_cast<std::size_t>(at)];
  std::nth_element(finite.begin(), finite.end() - 1 - at, finite.end());
  const double high = *(finite.end() - 1 - at);
  return {low, high};
}

ValueRange symmetric(ValueRange range) {
  const double m = std::max(std::abs(range.low), std::abs(range.high));
  return {-m, m};
}

ValueRange automatic_range(SurfaceMap map, std::span<const float> values, double limit) {
  if (has_limit(map)) return range_round(map, limit);
  const ValueRange inner = percentile_range(values, 0.02);
  const bool diverging = scale_of(map) == ColorScale::diverging;
  const double m = std::max(std::abs(inner.low), std::abs(inner.high));
  // Below this, values are rounding noise of a plane, and a full scale of noise would mislead.
  const double end = m > 1e-12 ? nice_end(m) : 1.0;
  return diverging ? ValueRange{-end, end} : ValueRange{0, end};
}

ValueRange value_range(SurfaceMap map, const MapRange& settings, std::span<const float> values,
                       double limit) {
  ValueRange range;
  switch (settings.mode) {
    case RangeMode::symmetric:
      return automatic_range(map, values, limit);
    case RangeMode::manual:
      return {settings.low, settings.high, limit};
    case RangeMode::percentile:
      range = percentile_range(values, 0.02);
      break;
    case RangeMode::full:
      range = full_range(values);
      break;
  }
  // A constant, even with rounding noise, gets a range of its own magnitude.
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  range.centre = limit;
  if (range.high - range.low > 1e-5 * size && size > 1e-12) return range;
  const double margin = size > 1e-12 ? 0.5 * size : 1.0, middle = (range.low + range.high) / 2;
  return {middle - margin, middle + margin, limit};
}

std::vector<Tick> legend_ticks(ValueRange range, int count) {
  HARIKO_ASSERT(count >= 2, "a legend has at least two ticks");
  const double extent = range.high - range.low;
  if (!(extent > 0) || !std::isfinite(extent)) return {{range.low, 0.5, format_number(range.low)}};
  const TickStep chosen = tick_step(range, count);
  const double step = chosen.length(), slack = 1e-9 * step;
  const auto first = std::ceil((range.low - slack) / step), last = std::floor((range.high + slack) / step);
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const bool scientific = largest >= 1e6 || largest < 1e-3;
  std::vector<Tick> ticks;
  for (double i = first; i <= last; ++i) {
    Tick tick;
    tick.value = i * step;
    tick.fraction = std::clamp(range.fraction(tick.value), 0.0, 1.0);
    if (i == 0) {
      tick.label = "0";
    } else if (scientific) {
      tick.label = format_number(tick.value, 3);
    } else {
      std::array<char, 64> buffer{};
      const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), tick.value,
                                     std::chars_format::fixed, chosen.decimals());
      tick.label.assign(buffer.data(), end.ptr);
      use_real_minus(tick.label);
    }
    ticks.push_back(std::move(tick));
  }
  return ticks;
}

std::string format_number(double value, int digits) {
  if (!std::isfinite(value)) return "\u2013";
  if (value == 0) return "0";
  std::array<char, 64> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  std::string text(buffer.data(), end.ptr);
  use_real_minus(text);
  return text;
}

std::vector<float> histogram(std::span<const float> values, ValueRange range, int bins) {
  HARIKO_ASSERT(bins >= 1, "a histogram has bins");
  std::vector<float> out(static_cast<std::size_t>(bins), 0.0F);
  for (const float value : values) {
    if (!std::isfinite(value) || value < range.low || value > range.high) continue;
    const auto bin = static_cast<std::size_t>(range.fraction(value) * bins);
    out[std::min(bin, out.size() - 1)] += 1.0F;
  }
  const float largest = *std::max_element(out.begin(), out.end());
  if (largest > 0)
    for (float& share : out) share /= largest;
  return out;
}

}  // namespace hariko

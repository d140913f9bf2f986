#include "render/text_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hariko {

namespace {

constexpr int dots_high = 7, dots_below = 1, dots_wide = 5, dots_apart = 6;
/// Side of a dot at size 1: capitals are as high as those of usual fonts.
constexpr double dot_side = 0.727 / dots_high;

/// Characters from the space to the tilde: a byte a column, from the left, its lowest bit at the top.
constexpr std::array<std::uint64_t, 95> dot_letters{
    0x0000000000, 0x00005f0000, 0x0007000700, 0x147f147f14, 0x242a7f2a12, 0x2313086462, 0x3649552250,
    0x0000070000, 0x001c224100, 0x0041221c00, 0x14083e0814, 0x08083e0808, 0x0080600000, 0x0808080808,
    0x0060600000, 0x2010080402, 0x3e5149453e, 0x00427f4000, 0x4261514946, 0x2141454b31, 0x1814127f10,
    0x2745454539, 0x3c4a494930, 0x0171090503, 0x3649494936, 0x064949291e, 0x0036360000, 0x00806c0000,
    0x0814224100, 0x1414141414, 0x0041221408, 0x0201510906, 0x3e415d551e, 0x7e1111117e, 0x7f49494936,
    0x3e41414122, 0x7f4141221c, 0x7f49494941, 0x7f09090901, 0x3e4149497a, 0x7f0808087f, 0x00417f4100,
    0x2040413f01, 0x7f08142241, 0x7f40404040, 0x7f020c027f, 0x7f0408107f, 0x3e4141413e, 0x7f09090906,
    0x3e4151215e, 0x7f09192946, 0x4649494931, 0x01017f0101, 0x3f4040403f, 0x1f2040201f, 0x3f4038403f,
    0x6314081463, 0x0708700807, 0x6151494543, 0x007f414100, 0x0204081020, 0x0041417f00, 0x0402010204,
    0x4040404040, 0x0001020400, 0x2054545478, 0x7f48444438, 0x3844444420, 0x384444487f, 0x3854545418,
    0x087e090102, 0x18a4a4a47c, 0x7f08040478, 0x00447d4000, 0x4080847d00, 0x7f10284400, 0x00417f4000,
    0x7c04180478, 0x7c08040478, 0x3844444438, 0xfc24242418, 0x18242418fc, 0x7c08040408, 0x4854545420,
    0x043f444020, 0x3c4040207c, 0x1c2040201c, 0x3c4030403c, 0x4428102844, 0x1ca0a0a07c, 0x4464544c44,
    0x0008364100, 0x00007f0000, 0x0041360800, 0x0804081008};

constexpr std::array<std::pair<char32_t, std::uint64_t>, 8> dot_signs{{
    {U'\u00b0', 0x0006090906},  // degree
    {U'\u00b1', 0x44445f4444},  // plus or minus
    {U'\u00b2', 0x0019151200},  // squared
    {U'\u00b3', 0x0011150a00},  // cubed
    {U'\u00b7', 0x0000080000},  // middle dot
    {U'\u00d7', 0x2214081422},  // times
    {U'\u2026', 0x4000400040},  // ellipsis
    {U'\u2212', 0x0808080808},  // minus
}};

std::uint64_t dots_of(char32_t character) {
  if (character >= U' ' && character <= U'~') return dot_letters[character - U' '];
  for (const auto& [sign, dots] : dot_signs)
    if (sign == character) return dots;
  return 0x7f4141417f;
}

/// Whether there is a dot at a place of the text, in dots: right of its start, below the top of its capitals.
bool dotted(std::u32string_view text, double across, double down) {
  if (across < 0 || down < 0 || down >= dots_high + dots_below) return false;
  const auto column = static_cast<std::size_t>(across);
  const std::size_t letter = column / dots_apart, place = column % dots_apart;
  if (letter >= text.size() || place >= dots_wide) return false;
  const std::uint64_t byte = dots_of(text[letter]) >> (8 * (dots_wide - 1 - place));
  return (byte >> static_cast<unsigned>(down) & 1U) != 0;
}

}  // namespace

double dot_text_width(std::u32string_view text, double size) {
  return static_cast<double>(dots_apart * text.size()) * dot_side * size;
}

void paint_dot_text(Image& image, std::u32string_view text, const Vector2& start, double angle, double size,
                    const Color& color) {
  constexpr int samples = 4;
  if (!(size > 0) || text.empty()) return;
  const double dot = dot_side * size;
  const Vector2 along(std::cos(angle), -std::sin(angle)), down(std::sin(angle), std::cos(angle));
  const Vector2 corner = start - dots_high * dot * down;
  const Vector2 width = dot_text_width(text, size) * along, height = (dots_high + dots_below) * dot * down;
  const Vector2 low = corner + width.cwiseMin(0.0) + height.cwiseMin(0.0);
  const Vector2 high = corner + width.cwiseMax(0.0) + height.cwiseMax(0.0);
  const auto first = [](double at) { return std::max(0, static_cast<int>(std::floor(at))); };
  const auto last = [](double at, int most) { return std::min(most, static_cast<int>(std::ceil(at))); };
  for (int y = first(low.y()); y < last(high.y(), image.height); ++y)
    for (int x = first(low.x()); x < last(high.x(), image.width); ++x) {
      int hits = 0;
      for (int i = 0; i < samples * samples; ++i) {
        const Vector2 at =
            Vector2(x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples) - corner;
        hits += dotted(text, at.dot(along) / dot, at.dot(down) / dot) ? 1 : 0;
      }
      if (hits > 0) image.blend(x, y, color, double(hits) / (samples * samples));
    }
}

}  // namespace hariko

#include "ui/base/drawn_icons.hpp"

#include <algorithm>
#include <cmath>

#include "ui/base/icons.hpp"

namespace hariko {

namespace {

using Point = DrawnIcon::Point;

constexpr float side = 24;
constexpr int samples = 4;  // a pixel's side

std::vector<Point> ellipse(float x, float y, float a, float b) {
  std::vector<Point> points;
  for (int i = 0; i <= 32; ++i) {
    const float angle = static_cast<float>(i) * 6.2831853F / 32;
    points.push_back({x + a * std::cos(angle), y + b * std::sin(angle)});
  }
  return points;
}

std::vector<DrawnIcon> draw() {
  const std::vector<Point> frame{{3, 3}, {21, 3}, {21, 21}, {3, 21}, {3, 3}};
  return {
      {icon::extrude_code,
       {{{12, 1}, {18.5F, 8.5F}, {5.5F, 8.5F}}, {{10.4F, 8}, {13.6F, 8}, {13.6F, 14}, {10.4F, 14}}},
       {{{{7, 14}, {3, 14}, {3, 22}, {21, 22}, {21, 14}, {17, 14}}, 2.4F}}},
      {icon::inset_code, {{{8, 8}, {16, 8}, {16, 16}, {8, 16}}}, {{frame, 2.2F}}},
      {icon::bevel_code,
       {{{2, 3}, {11, 3}, {21, 13}, {21, 22}, {2, 22}}},
       {{{{15.5F, 3.8F}, {20.2F, 3.8F}, {20.2F, 8.5F}}, 1.8F}}},
      {icon::loop_cut_code, {}, {{frame, 2.2F}, {{{1, 12}, {23, 12}}, 3}}},
      {icon::knife_code,
       {{{22, 1.5F}, {21, 8}, {13.5F, 16}, {8.5F, 11.5F}}},
       {{{{8.6F, 15.4F}, {3.6F, 20.4F}}, 4.4F}}},
      {icon::lasso_code,
       {},
       {{ellipse(12.5F, 9.5F, 9.5F, 6.8F), 2.2F}, {{{6.5F, 15}, {5, 17.5F}, {6, 20}, {4.5F, 23}}, 2.2F}}},
      {icon::mirror_code,
       {{{9, 3}, {9, 21}, {0.5F, 21}}},
       {{{{12, 1.5F}, {12, 22.5F}}, 1.6F}, {{{16, 6}, {16, 20}, {22.2F, 20}, {16, 6}}, 2}}},
  };
}

/// Even-odd rule.
bool inside(const std::vector<Point>& outline, Point p) {
  bool odd = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point &a = outline[i], &b = outline[j];
    if ((a[1] > p[1]) == (b[1] > p[1])) continue;
    if (p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])) odd = !odd;
  }
  return odd;
}

bool covered(const DrawnIcon::Stroke& stroke, Point p) {
  const float reach = stroke.width * stroke.width / 4;
  for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
    const Point &a = stroke.points[i], &b = stroke.points[i + 1];
    const float x = b[0] - a[0], y = b[1] - a[1], length = x * x + y * y;
    const float t = length > 0 ? std::clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y) / length, 0.0F, 1.0F) : 0;
    const float dx = a[0] + t * x - p[0], dy = a[1] + t * y - p[1];
    if (dx * dx + dy * dy <= reach) return true;
  }
  return false;
}

bool covered(const DrawnIcon& icon, Point p) {
  return std::ranges::any_of(icon.fills, [&](const auto& fill) { return inside(fill, p); }) ||
         std::ranges::any_of(icon.strokes, [&](const auto& s) { return covered(s, p); });
}

}  // namespace

std::span<const DrawnIcon> drawn_icons() {
  static const std::vector<DrawnIcon> icons = draw();
  return icons;
}

std::vector<unsigned char> rasterised(const DrawnIcon& icon, int size) {
  std::vector<unsigned char> out(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const float step = side / static_cast<float>(size * samples);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      int hits = 0;
      for (int s = 0; s < samples * samples; ++s) {
        const float i = static_cast<float>(x * samples + s % samples) + 0.5F;
        const float j = static_cast<float>(y * samples + s / samples) + 0.5F;
        hits += covered(icon, {i * step, j * step});
      }
      out[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)] =
          static_cast<unsigned char>(hits * 255 / (samples * samples));
    }
  return out;
}

}  // namespace hariko

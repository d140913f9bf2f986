#include "render/legend.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render/text_painter.hpp"

namespace hariko {

namespace {

/// Fills the rectangle [x0, x1] x [y0, y1], with partial coverage at its border.
void fill(Image& image, double x0, double y0, double x1, double y1, Color color) {
  for (int y = static_cast<int>(std::floor(y0)); y < y1; ++y)
    for (int x = static_cast<int>(std::floor(x0)); x < x1; ++x) {
      const double across = std::min(x + 1.0, x1) - std::max(double(x), x0);
      const double along = std::min(y + 1.0, y1) - std::max(double(y), y0);
      image.blend(x, y, color, std::max(0.0, across) * std::max(0.0, along));
    }
}

}  // namespace

void paint_legend(Image& image, const Legend& legend, const std::optional<FontFile>& font) {
  const double s = legend.scale;
  // In a small picture the bar takes at most half the height.
  const double height = std::min(200 * s, 0.5 * image.height), width = 14 * s;
  const double left = 24 * s, bottom = image.height - 28 * s, top = bottom - height;
  const Color text = legend.on_dark ? color_from_hex("#e6e6e6") : color_from_hex("#2b2d31");
  const Color frame{text.r, text.g, text.b, 0.45F};
  TextPainter painter(font);
  const double size = 13 * s;
  const std::vector<Tick> ticks = legend_ticks(legend.range, 5);
  std::string heading(title_of(legend.map));
  if (!legend.unit.empty()) heading += " [" + legend.unit + "]";
  // Translucent panel behind the legend, so that the text is readable over the model.
  const double body = (legend.histogram.empty() ? 0 : 40 * s) + width + 10 * s;
  double across = painter.width(heading, size);
  for (const Tick& tick : ticks) across = std::max(across, body + painter.width(tick.label, size));
  const Color panel = legend.on_dark ? color_from_hex("#1e1f22") : color_from_hex("#f7f8fa");
  fill(image, left - 12 * s, top - 34 * s, left + across + 12 * s, bottom + 12 * s,
       {panel.r, panel.g, panel.b, 0.72F});
  double x = left;
  if (!legend.histogram.empty()) {
    const double room = 36 * s, bins = static_cast<double>(legend.histogram.size());
    x += room + 4 * s;
    for (std::size_t i = 0; i < legend.histogram.size(); ++i) {
      const double y1 = bottom - height * static_cast<double>(i) / bins;
      fill(image, left + room * (1 - static_cast<double>(legend.histogram[i])), y1 - height / bins,
           left + room, y1, {text.r, text.g, text.b, 0.35F});
    }
  }
  fill(image, x - s, top - s, x + width + s, bottom + s, frame);
  for (int y = 0; y < static_cast<int>(std::ceil(height)); ++y) {
    const double y0 = top + y, y1 = std::min(y0 + 1, bottom);
    const double value = legend.range.low + (1 - (y + 0.5) / height) * (legend.range.high - legend.range.low);
    fill(image, x, y0, x + width, y1,
         color_of_value(legend.map, legend.range, legend.colour_blind_safe, value));
  }
  const double limit_at = legend.range.fraction(legend.range.centre);
  if (has_limit(legend.map) && limit_at > 0 && limit_at < 1) {
    const double y = bottom - limit_at * height;
    fill(image, x - 3 * s, y - s, x + width + 3 * s, y + s, text);
  }
  for (const Tick& tick : ticks) {
    const double y = bottom - tick.fraction * height;
    fill(image, x + width + s, y - 0.5 * s, x + width + 6 * s, y + 0.5 * s, text);
    painter.paint(image, tick.label, x + width + 10 * s, y + 0.36 * size, size, text);
  }
  painter.paint(image, heading, left, top - 14 * s, size, text);
}

}  // namespace hariko

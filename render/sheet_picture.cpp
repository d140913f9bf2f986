#include "render/sheet_picture.hpp"

#include <algorithm>
#include <cmath>

#include "core/unfolding/pages/write_sheets.hpp"
#include "render/text_painter.hpp"

namespace hariko {

namespace {

constexpr double most_pixels = 40e6;
constexpr double capital_height = 0.727;   ///< height of capitals in Inter and similar fonts, at size 1
constexpr double dash = 1.6, pause = 1.1;  // mm

struct Pen {
  Color color;
  double width = 0.2;  ///< mm
  bool dashed = false;
};

Pen pen_of(SheetLayer layer) {
  switch (layer) {
    case SheetLayer::fold_mountain:
      return {color_from_hex("#c22f2f"), 0.15, false};
    case SheetLayer::fold_valley:
      return {color_from_hex("#2255bb"), 0.15, true};
    case SheetLayer::tab:
    case SheetLayer::strip:
      return {color_from_hex("#777777"), 0.2, false};
    case SheetLayer::label:
      return {color_from_hex("#444444"), 0.2, false};
    case SheetLayer::cut:
      break;
  }
  return {color_from_hex("#000000"), 0.2, false};
}

/// Draws a line of `width` pixels with round ends, with approximate coverage of the pixels.
void stroke(Image& image, const Vector2& from, const Vector2& to, double width, const Color& color) {
  const Vector2 along = to - from;
  const double length = along.norm(), reach = width / 2 + 1;
  const bool steep = std::abs(along.y()) > std::abs(along.x());
  const Eigen::Index major = steep ? 1 : 0, minor = 1 - major;
  const double low = std::min(from[major], to[major]), high = std::max(from[major], to[major]);
  const double slope = length > 0 ? along[minor] / along[major] : 0;
  const double spread = reach * std::hypot(1, length > 0 ? slope : 0);
  const int last = std::min(static_cast<int>(std::ceil(high + reach)), std::max(image.width, image.height));
  for (int i = std::max(0, static_cast<int>(std::floor(low - reach))); i <= last; ++i) {
    const double at = std::clamp(i + 0.5, low, high);
    const double middle = length > 0 ? from[minor] + slope * (at - from[major]) : from[minor];
    for (int k = static_cast<int>(std::floor(middle - spread)); k <= static_cast<int>(middle + spread); ++k) {
      Vector2 pixel;
      pixel[major] = i + 0.5;
      pixel[minor] = k + 0.5;
      const double t = length > 0 ? std::clamp((pixel - from).dot(along) / (length * length), 0.0, 1.0) : 0;
      const double distance = (pixel - from - t * along).norm();
      // Lines thinner than a pixel become paler instead of narrower.
      const double coverage =
          std::min(1.0, width) * std::clamp(std::max(width, 1.0) / 2 + 0.5 - distance, 0.0, 1.0);
      steep ? image.blend(k, i, color, coverage) : image.blend(i, k, color, coverage);
    }
  }
}

}  // namespace

double sheet_resolution(const SheetDrawing& drawing, double wanted) {
  const double pages = std::max<Index>(1, drawing.page_count);
  const double area = pages * (drawing.page.width + page_spacing) * drawing.page.height;
  return std::min(wanted, std::sqrt(most_pixels / area));
}

Image sheet_picture(const SheetDrawing& drawing, double dots) {
  const double pages = std::max<Index>(1, drawing.page_count);
  const double width = pages * drawing.page.width + (pages - 1) * page_spacing;
  Image image(std::max(1, static_cast<int>(std::lround(width * dots))),
              std::max(1, static_cast<int>(std::lround(drawing.page.height * dots))));
  const auto left = [&](Index page) { return page * (drawing.page.width + page_spacing); };
  for (int x = 0; x < image.width; ++x) {
    const double at = std::fmod((x + 0.5) / dots, drawing.page.width + page_spacing);
    const std::uint8_t shade = at <= drawing.page.width ? 255 : 214;
    for (int y = 0; y < image.height; ++y) {
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = pixel[1] = pixel[2] = shade;
      pixel[3] = 255;
    }
  }
  const auto dot = [&](Index page, const Vector2& p) {
    return Vector2((left(page) + p.x()) * dots, (drawing.page.height - p.y()) * dots);
  };
  for (const DrawnLine& line : drawing.lines) {
    const Pen pen = pen_of(line.layer);
    const Vector2 from = dot(line.page, line.from), to = dot(line.page, line.to);
    if (!pen.dashed) {
      stroke(image, from, to, pen.width * dots, pen.color);
      continue;
    }
    const double length = (to - from).norm();
    const Vector2 along = length > 0 ? Vector2((to - from) / length) : Vector2(0, 0);
    for (double begin = 0; begin < length; begin += (dash + pause) * dots)
      stroke(image, from + begin * along, from + std::min(length, begin + dash * dots) * along,
             pen.width * dots, pen.color);
  }
  TextPainter painter;
  for (const DrawnText& text : drawing.texts) {
    const double size = text.height / capital_height * dots;
    painter.paint_turned(image, text.text, dot(text.page, text.centre), text.angle, size, text.height * dots,
                         color_from_hex("#222222"));
  }
  return image;
}

}  // namespace hariko

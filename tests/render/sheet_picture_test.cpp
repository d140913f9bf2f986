// Pictures of pages: ink where lines and words are, and nowhere else.

#include "render/sheet_picture.hpp"

#include <gtest/gtest.h>

#include "core/unfolding/pages/write_sheets.hpp"

namespace hariko {
namespace {

/// A tent over a square, and its pages.
SheetDrawing tent_pages(bool inside = false) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, -0.4}};
  for (Index k = 0; k < 4; ++k) mesh.add_face({k, (k + 1) % 4, 4});
  PaperSettings settings{.scale = 120};
  settings.inside = inside;
  const auto graph = std::make_shared<const FacetGraph>(FacetGraph::build(mesh).value());
  return draw_sheets(unfold(graph, settings, {.steps = 100}).value());
}

int darkness(const Image& image, int x, int y) {
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return 0;
  const std::uint8_t* pixel = image.pixel(x, y);
  return 255 - std::min({pixel[0], pixel[1], pixel[2]});
}

TEST(SheetPicture, HasInkAlongLinesAndNowhereElse) {
  for (const bool inside : {false, true}) {
    const SheetDrawing drawing = tent_pages(inside);
    const double dots = 8;
    const Image image = sheet_picture(drawing, dots);
    ASSERT_EQ(image.height, 8 * 297);
    ASSERT_EQ(image.width,
              int(std::lround(dots * (drawing.page_count * 210 + (drawing.page_count - 1) * page_spacing))));
    std::vector<char> explained(
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0);
    const auto explain = [&](const Vector2& p, int reach) {
      for (int y = int(p.y()) - reach; y <= int(p.y()) + reach; ++y)
        for (int x = int(p.x()) - reach; x <= int(p.x()) + reach; ++x)
          if (x >= 0 && y >= 0 && x < image.width && y < image.height)
            explained[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x)] = 1;
    };
    const auto dot = [&](Index page, const Vector2& p) {
      return Vector2(dots * (page * (210 + page_spacing) + p.x()), dots * (297 - p.y()));
    };
    std::size_t valleys = 0;
    for (const DrawnLine& line : drawing.lines) {
      const Vector2 from = dot(line.page, line.from), to = dot(line.page, line.to);
      const int steps = std::max(2, int((to - from).norm()));
      valleys += line.layer == SheetLayer::fold_valley ? 1 : 0;
      int pale = 0;
      for (int k = 0; k <= steps; ++k) {
        const Vector2 p = from + (to - from) * k / steps;
        explain(p, 2);
        int ink = 0;
        for (int dx = -1; dx <= 1; ++dx)
          for (int dy = -1; dy <= 1; ++dy)
            ink = std::max(ink, darkness(image, int(p.x()) + dx, int(p.y()) + dy));
        pale += ink < 60 ? 1 : 0;
      }
      if (line.layer == SheetLayer::fold_valley)
        EXPECT_TRUE(pale > 0.15 * steps && pale < 0.6 * steps) << "dashes";
      else
        EXPECT_EQ(pale, 0);
    }
    EXPECT_EQ(valleys > 0, !inside) << "the inside of a hollow is a hill";
    for (const DrawnText& text : drawing.texts) {
      const int reach = int(dots * text.height * (0.6 + 0.5 * double(text.text.size())));
      const Vector2 middle = dot(text.page, text.centre);
      int ink = 0;
      for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x)
          ink += darkness(image, int(middle.x()) + x, int(middle.y()) + y) > 100 ? 1 : 0;
      EXPECT_GT(ink, 0) << text.text;
      explain(middle, reach);
    }
    std::size_t stray = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        stray += darkness(image, x, y) > 60 &&
                         !explained[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                    static_cast<std::size_t>(x)]
                     ? 1
                     : 0;
    EXPECT_EQ(stray, 0U);
  }
}

TEST(SheetPicture, ManyPagesGetFewerDots) {
  SheetDrawing drawing = tent_pages();
  EXPECT_EQ(sheet_resolution(drawing), sheet_dots);
  drawing.page_count = 400;
  const double dots = sheet_resolution(drawing);
  EXPECT_LE(dots * dots * 400 * 230 * 297, 40.1e6);
  EXPECT_GT(dots, 1);
}

}  // namespace
}  // namespace hariko

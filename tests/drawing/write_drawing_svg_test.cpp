#include "core/drawing/write_drawing_svg.hpp"

#include <gtest/gtest.h>

namespace hariko {

TEST(WriteDrawingSvg, LayersPathsAndSizes) {
  LineDrawing drawing{640, 480, {}};
  drawing.lines.push_back({LineKind::network, false, {{1, 2}, {3.14159, 4}}});
  drawing.lines.push_back({LineKind::silhouette, true, {{0, 0}, {1, 0}, {1, 1}, {0, 0}}});
  drawing.lines.push_back({LineKind::silhouette, false, {{-0.001, 5}, {6, 7}, {8, 9}}});
  const std::string svg = write_drawing_svg(drawing, PageUnit::pixel);
  EXPECT_NE(svg.find("width=\"640px\" height=\"480px\" viewBox=\"0 0 640 480\""), std::string::npos);
  EXPECT_NE(svg.find("<path d=\"M1 2L3.14 4\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<path d=\"M0 0L1 0 1 1Z\"/>"), std::string::npos);
  EXPECT_NE(svg.find("<path d=\"M0 5L6 7 8 9\"/>"), std::string::npos) << "no minus before zero";
  // Visible lines are drawn over hidden ones, silhouettes over the network.
  const auto hidden = svg.find("id=\"silhouette-hidden\""), network = svg.find("id=\"network\""),
             silhouette = svg.find("id=\"silhouette\"");
  ASSERT_NE(hidden, std::string::npos);
  EXPECT_LT(hidden, network);
  EXPECT_LT(network, silhouette);
  EXPECT_EQ(svg.find("id=\"border\""), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray", hidden), std::string::npos);
}

TEST(WriteDrawingSvg, MillimetresAreThoseOfThePage) {
  // An A5 page across, with a line from corner to corner.
  LineDrawing drawing{210 * pixels_per_millimetre, 148 * pixels_per_millimetre, {}};
  drawing.lines.push_back({LineKind::silhouette, false, {{0, 0}, {drawing.width, drawing.height}}});
  const std::string svg = write_drawing_svg(drawing, PageUnit::millimetre);
  EXPECT_NE(svg.find("width=\"210mm\" height=\"148mm\" viewBox=\"0 0 210 148\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("<path d=\"M0 0L210 148\"/>"), std::string::npos) << svg;
  EXPECT_NE(svg.find("stroke-width=\"0.5\""), std::string::npos) << svg;
  // The same pen in pixels.
  EXPECT_NE(write_drawing_svg(drawing, PageUnit::pixel).find("stroke-width=\"1.89\""), std::string::npos);
}

}  // namespace hariko

#include "core/drawing/write_drawing_svg.hpp"

#include <gtest/gtest.h>

namespace hariko {

TEST(WriteDrawingSvg, LayersPathsAndSizes) {
  LineDrawing drawing{640, 480, {}};
  drawing.strokes.push_back({StrokeKind::network, false, {{1, 2}, {3.14159, 4}}});
  drawing.strokes.push_back({StrokeKind::silhouette, true, {{0, 0}, {1, 0}, {1, 1}, {0, 0}}});
  drawing.strokes.push_back({StrokeKind::silhouette, false, {{-0.001, 5}, {6, 7}, {8, 9}}});
  const std::string svg = write_drawing_svg(drawing, "px");
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

}  // namespace hariko

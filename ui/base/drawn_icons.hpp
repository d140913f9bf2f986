#pragma once

// Icons that the icon font lacks, drawn as shapes: the tools that change polyhedra.

#include <array>
#include <span>
#include <vector>

namespace hariko {

/// A picture in a square of 24 units, x to the right, y down: filled outlines and round strokes.
struct DrawnIcon {
  using Point = std::array<float, 2>;
  struct Stroke {
    std::vector<Point> points;
    float width = 2;
  };
  unsigned short code = 0;  ///< the character that stands for it, see icons.hpp
  std::vector<std::vector<Point>> fills;
  std::vector<Stroke> strokes;
};

std::span<const DrawnIcon> drawn_icons();

/// Coverage 0 .. 255 of `size` x `size` pixels, rows from the top. O(pixels * points).
std::vector<unsigned char> rasterised(const DrawnIcon& icon, int size);

}  // namespace hariko

#pragma once

// RadianceImage: a picture in linear light without an upper limit, as surroundings need it.

#include <array>
#include <cstddef>
#include <vector>

namespace hariko {

/// Linear red, green and blue with the primaries of sRGB; 1 is the white of a screen.
using Radiance = std::array<float, 3>;

/// Picture in linear light, rows from top to bottom.
struct RadianceImage {
  int width = 0, height = 0;
  std::vector<Radiance> pixels;

  RadianceImage() = default;
  RadianceImage(int columns, int rows)
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), Radiance{}) {}
  Radiance& at(int x, int y) { return pixels[offset(x, y)]; }
  const Radiance& at(int x, int y) const { return pixels[offset(x, y)]; }

 private:
  std::size_t offset(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace hariko

#pragma once

// Pictures like photographs for benchmarks.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/files/file_io.hpp"
#include "render/camera.hpp"
#include "render/image.hpp"

namespace hariko {

inline constexpr PixelSize eight_megapixels{3464, 2310};

/// Waves of colour with some grain: neither flat nor noise.
inline Image bench_photograph(PixelSize size) {
  Image image(size.width, size.height);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      std::uint8_t* p = image.pixel(x, y);
      for (int c = 0; c < 3; ++c)
        p[c] =
            static_cast<std::uint8_t>(128 + 100 * std::sin(0.01 * (x + 2 * y) + c) + (7 * x + 13 * y) % 17);
      p[3] = 255;
    }
  return image;
}

/// Bytes of a PNG file.
inline std::string png_of(const Image& image) {
  const auto path = std::filesystem::temp_directory_path() / "hariko_bench_photograph.png";
  (void)write_png(path, image);
  std::string bytes = read_file(path).value();
  std::filesystem::remove(path);
  return bytes;
}

}  // namespace hariko

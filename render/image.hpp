#pragma once

// Image: pixels in memory, and their PNG files.

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "render/camera.hpp"
#include "render/color_map.hpp"

namespace hariko {

inline constexpr Code e_image_encode{"E_IMAGE_ENCODE"};
inline constexpr Code e_image_read{"E_IMAGE_READ"};

/// Image in 8-bit sRGB with straight alpha, rows from top to bottom.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  Image(int columns, int rows)
      : width(columns),
        height(rows),
        rgba(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * 4) {}
  std::uint8_t* pixel(int x, int y) { return rgba.data() + offset(x, y); }
  const std::uint8_t* pixel(int x, int y) const { return rgba.data() + offset(x, y); }
  /// Blends a colour over a pixel with coverage in [0, 1]; pixels outside the image are ignored.
  void blend(int x, int y, Color color, double coverage);

 private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4;
  }
};

/// Writes a PNG file atomically: it is either the old or the whole new one. Errors: E_FILE_WRITE,
/// E_IMAGE_ENCODE.
Result<Done> write_png(const std::filesystem::path& path, const Image& image);
/// Reads a PNG file. Errors: those of read_file, E_IMAGE_READ (also above 64 million pixels).
Result<Image> read_png(const std::filesystem::path& path);

/// Whether bytes begin like a PNG file.
bool looks_like_png(std::string_view file);
/// Size of a PNG file in memory. Errors: E_IMAGE_READ.
Result<PixelSize> png_size(std::string_view file);
/// Pixels of a PNG file in memory. Errors: E_IMAGE_READ, also above `most_pixels`.
Result<Image> decode_png(std::string_view file, std::uint64_t most_pixels);

/// Image averaged over blocks of factor x factor pixels, in linear light. Width and height must be multiples
/// of the factor.
Image downsample(const Image& image, int factor);

}  // namespace hariko

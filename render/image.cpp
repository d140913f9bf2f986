#include "render/image.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/files/file_io.hpp"
#include "core/base/text/sanitized_utf8.hpp"

namespace hariko {

namespace {

constexpr std::uint64_t most_pixels = 64'000'000;
constexpr std::uint64_t largest_file = std::uint64_t{1} << 29;

/// Owner of libpng's simplified image, which is freed on every path.
struct PngImage {
  png_image image{};
  PngImage() { image.version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(&image); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
};

Message damaged_png(const PngImage& png) {
  return make_error(e_image_read,
                    std::string("The picture is a damaged PNG file: ") + png.image.message + ".",
                    "Save it again with a program for pictures.");
}

float to_linear(std::uint8_t value) {
  const float x = static_cast<float>(value) / 255.0F;
  return x <= 0.04045F ? x / 12.92F : std::pow((x + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t byte_from_linear(float x) {
  const float encoded = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(std::clamp(encoded, 0.0F, 1.0F) * 255.0F));
}

}  // namespace

void Image::blend(int x, int y, Color color, double coverage) {
  if (x < 0 || y < 0 || x >= width || y >= height || coverage <= 0) return;
  std::uint8_t* at = pixel(x, y);
  const double over = std::min(coverage, 1.0) * color.a;
  const double under = at[3] / 255.0 * (1 - over), alpha = over + under;
  const std::array<float, 3> paint{color.r, color.g, color.b};
  for (std::size_t i = 0; i < 3; ++i)
    at[i] = static_cast<std::uint8_t>(std::lround((paint[i] * 255.0 * over + at[i] * under) / alpha));
  at[3] = static_cast<std::uint8_t>(std::lround(alpha * 255));
}

Result<Done> write_png(const std::filesystem::path& path, const Image& image) {
  HARIKO_ASSERT(image.width > 0 && image.height > 0, "a picture has pixels");
  const auto failed = [&](const char* why) {
    return make_error(e_image_encode,
                      "The picture " + sanitized_utf8(path.string()) + " could not be encoded: " + why + ".",
                      "Try a smaller picture.");
  };
  PngImage png;
  png.image.width = static_cast<png_uint_32>(image.width);
  png.image.height = static_cast<png_uint_32>(image.height);
  png.image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  if (!png_image_write_to_memory(&png.image, nullptr, &size, 0, image.rgba.data(), image.width * 4, nullptr))
    return failed(png.image.message);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png.image, bytes.data(), &size, 0, image.rgba.data(), image.width * 4,
                                 nullptr))
    return failed(png.image.message);
  bytes.resize(size);
  return write_file_atomic(path, bytes);
}

Result<Image> read_png(const std::filesystem::path& path) {
  const Result<std::string> bytes = read_file(path, largest_file);
  if (!bytes) return bytes.error();
  Result<Image> image = decode_png(*bytes, most_pixels);
  if (image) return image;
  return make_error(e_image_read, "The picture " + sanitized_utf8(path.string()) + ": " + image.error().text,
                    "Check that it is a PNG file.");
}

bool looks_like_png(std::string_view file) {
  return file.starts_with("\x89PNG\r\n\x1a\n");
}

Result<PixelSize> png_size(std::string_view file) {
  PngImage png;
  if (!png_image_begin_read_from_memory(&png.image, file.data(), file.size())) return damaged_png(png);
  return PixelSize{static_cast<int>(png.image.width), static_cast<int>(png.image.height)};
}

Result<Image> decode_png(std::string_view file, std::uint64_t most) {
  PngImage png;
  if (!png_image_begin_read_from_memory(&png.image, file.data(), file.size())) return damaged_png(png);
  if (std::uint64_t(png.image.width) * png.image.height > most)
    return make_error(e_image_read, "The picture has too many pixels.", "Make it smaller.");
  png.image.format = PNG_FORMAT_RGBA;
  Image out(static_cast<int>(png.image.width), static_cast<int>(png.image.height));
  if (!png_image_finish_read(&png.image, nullptr, out.rgba.data(), out.width * 4, nullptr))
    return damaged_png(png);
  return out;
}

Image downsample(const Image& image, int factor) {
  HARIKO_ASSERT(factor >= 1 && image.width % factor == 0 && image.height % factor == 0,
                "the size must be a multiple of the factor");
  if (factor == 1) return image;
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < 256; ++i) linear[i] = to_linear(static_cast<std::uint8_t>(i));
  Image out(image.width / factor, image.height / factor);
  const float share = 1.0F / static_cast<float>(factor * factor);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      std::array<float, 3> sum{};  // weighted by alpha, so that transparent pixels do not tint the edge
      float alpha = 0;
      for (int j = 0; j < factor; ++j)
        for (int i = 0; i < factor; ++i) {
          const std::uint8_t* from = image.pixel(x * factor + i, y * factor + j);
          const float weight = static_cast<float>(from[3]) / 255.0F;
          for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * linear[from[c]];
          alpha += weight;
        }
      std::uint8_t* to = out.pixel(x, y);
      for (std::size_t c = 0; c < 3; ++c) to[c] = alpha > 0 ? byte_from_linear(sum[c] / alpha) : 0;
      to[3] = static_cast<std::uint8_t>(std::lround(alpha * share * 255.0F));
    }
  return out;
}

}  // namespace hariko

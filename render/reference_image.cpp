#include "render/reference_image.hpp"

#include <algorithm>
#include <array>

#include "core/base/files/file_ending.hpp"
#include "render/read_photo.hpp"

namespace hariko {

namespace {

constexpr std::uint64_t most_decoded_pixels = 100'000'000;

Message no_known_kind() {
  return make_error(e_picture_kind, "The file is no PNG, JPEG or WebP picture.",
                    "Save the picture as PNG or JPEG and use that.");
}

Message too_many_pixels() {
  return make_error(e_image_read, "The picture has more than 100 million pixels.",
                    "Make it smaller with a program for pictures.");
}

/// Multiplies colours by alpha, so that filtering does not mix in colours of transparent pixels.
void premultiply(Image& image) {
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const unsigned alpha = image.rgba[i + 3];
    if (alpha == 255) continue;
    for (std::size_t c = 0; c < 3; ++c)
      image.rgba[i + c] = static_cast<std::uint8_t>((image.rgba[i + c] * alpha + 127) / 255);
  }
}

/// Image of half the size, by means of 2 x 2 pixels; a side of one pixel stays.
Image halved(const Image& image) {
  Image out(std::max(1, image.width / 2), std::max(1, image.height / 2));
  const int right = image.width > 1 ? 1 : 0, below = image.height > 1 ? 1 : 0;
  for (int y = 0; y < out.height; ++y) {
    const int row = below ? 2 * y : 0;
    for (int x = 0; x < out.width; ++x) {
      const int column = right ? 2 * x : 0;
      const std::array<const std::uint8_t*, 4> from{
          image.pixel(column, row), image.pixel(column + right, row), image.pixel(column, row + below),
          image.pixel(column + right, row + below)};
      std::uint8_t* to = out.pixel(x, y);
      for (std::size_t c = 0; c < 4; ++c)
        to[c] = static_cast<std::uint8_t>((from[0][c] + from[1][c] + from[2][c] + from[3][c] + 2) / 4);
    }
  }
  return out;
}

bool too_large(const Image& image) {
  return std::int64_t(image.width) * image.height > ReferenceImage::most_kept_pixels ||
         std::max(image.width, image.height) > ReferenceImage::longest_side;
}

}  // namespace

std::span<const std::string_view> reference_endings() {
  static constexpr std::array<std::string_view, 4> endings{".png", ".jpg", ".jpeg", ".webp"};
  return std::span(endings).first(reads_webp() ? 4 : 3);
}

bool is_reference_file(const std::filesystem::path& path) {
  const auto endings = reference_endings();
  const std::string ending = lower_ending(path);
  return ending == ".webp" || std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::size_t ReferenceImage::bytes() const {
  std::size_t sum = 0;
  for (const Image& level : levels) sum += level.rgba.size();
  return sum;
}

Result<PixelSize> reference_size(std::string_view file) {
  Result<PixelSize> size = looks_like_png(file)    ? png_size(file)
                           : looks_like_jpeg(file) ? jpeg_size(file)
                           : looks_like_webp(file) ? webp_size(file)
                                                   : Result<PixelSize>(no_known_kind());
  if (size && std::uint64_t(size->width) * std::uint64_t(size->height) > most_decoded_pixels)
    return too_many_pixels();
  return size;
}

Result<ReferenceImage> decode_reference(std::string_view file, const CancelToken& cancel) {
  const Result<PixelSize> size = reference_size(file);
  if (!size) return size.error();
  Result<Image> decoded = looks_like_png(file)    ? decode_png(file, most_decoded_pixels)
                          : looks_like_jpeg(file) ? read_jpeg(file, most_decoded_pixels)
                                                  : read_webp(file, most_decoded_pixels);
  if (!decoded) return decoded.error();
  Image image = std::move(decoded).value();
  premultiply(image);
  while (too_large(image) && !cancel.cancelled()) image = halved(image);
  ReferenceImage out;
  out.size = *size;
  out.levels.push_back(std::move(image));
  while ((out.levels.back().width > 1 || out.levels.back().height > 1) && !cancel.cancelled())
    out.levels.push_back(halved(out.levels.back()));
  return out;
}

}  // namespace hariko

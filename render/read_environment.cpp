#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "render/environment.hpp"
#include "render/image.hpp"
#include "render/read_photo.hpp"
#include "render/read_radiance.hpp"
#include "render/reference_image.hpp"

namespace hariko {

namespace {

constexpr std::uint64_t most_environment_pixels = 100'000'000;  // limit for PNG and JPEG
constexpr double brightest = 60'000;                            // largest that half floats of the GPU hold

/// Texels of one side that a pixel of another number of pixels covers, and how far.
struct Coverage {
  int first = 0;
  std::vector<double> parts;  ///< in texels
};
Coverage coverage_of(int pixel, int pixels, int texels) {
  const double low = double(pixel) * texels / pixels, high = double(pixel + 1) * texels / pixels;
  Coverage out;
  out.first = std::min(static_cast<int>(low), texels - 1);
  for (int t = out.first; t < texels && t < high; ++t)
    out.parts.push_back(std::min(high, t + 1.0) - std::max(low, double(t)));
  return out;
}

/// Reducer of a picture to the size that is kept, row by row, by the means of areas.
class EnvironmentReducer {
 public:
  explicit EnvironmentReducer(PixelSize size)
      : rows_(size.height), sums_(std::size_t(environment_width) * environment_height) {
    for (int x = 0; x < size.width; ++x) columns_.push_back(coverage_of(x, size.width, environment_width));
  }

  void add(int row, std::span<const Radiance> pixels) {
    std::vector<std::array<double, 3>> line(environment_width);
    for (std::size_t x = 0; x < pixels.size(); ++x)
      for (std::size_t i = 0; i < columns_[x].parts.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
          line[std::size_t(columns_[x].first) + i][c] += columns_[x].parts[i] * double(pixels[x][c]);
    const Coverage down = coverage_of(row, rows_, environment_height);
    for (std::size_t i = 0; i < down.parts.size(); ++i)
      for (std::size_t x = 0; x < line.size(); ++x)
        for (std::size_t c = 0; c < 3; ++c)
          sums_[(std::size_t(down.first) + i) * environment_width + x][c] += down.parts[i] * line[x][c];
  }

  RadianceImage result() const {
    RadianceImage out(environment_width, environment_height);
    for (std::size_t i = 0; i < sums_.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c)
        out.pixels[i][c] = static_cast<float>(std::min(sums_[i][c], brightest));
    return out;
  }

 private:
  int rows_;
  std::vector<Coverage> columns_;
  std::vector<std::array<double, 3>> sums_;
};

Result<Done> check_shape(PixelSize size) {
  // Sides of pictures that were scaled are rounded
  if (std::abs(size.width - 2 * size.height) <= std::max(2, size.width / 50)) return Done{};
  return make_error(e_environment_shape,
                    "The picture has " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                        " pixels, and one of all directions is twice as wide as high.",
                    "Use an equirectangular panorama.");
}

/// Light of the values of a screen's channel.
std::array<float, 256> light_of_bytes() {
  std::array<float, 256> out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double x = double(i) / 255;
    out[i] = static_cast<float>(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4));
  }
  return out;
}

/// Picture of 8 bits; what is transparent is dark.
RadianceImage reduced_picture(const Image& image) {
  const std::array<float, 256> light = light_of_bytes();
  EnvironmentReducer reducer({image.width, image.height});
  std::vector<Radiance> row(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* pixel = image.pixel(x, y);
      const float opacity = static_cast<float>(pixel[3]) / 255;
      for (std::size_t c = 0; c < 3; ++c) row[std::size_t(x)][c] = opacity * light[pixel[c]];
    }
    reducer.add(y, row);
  }
  return reducer.result();
}

Result<RadianceImage> reduced_radiance(std::string_view file) {
  const auto size = radiance_size(file);
  if (!size) return size.error();
  if (const auto fits = check_shape(*size); !fits) return fits.error();
  EnvironmentReducer reducer(*size);
  const auto read =
      read_radiance(file, [&](int row, std::span<const Radiance> pixels) { reducer.add(row, pixels); });
  if (!read) return read.error();
  return reducer.result();
}

}  // namespace

std::span<const std::string_view> environment_endings() {
  static constexpr std::array<std::string_view, 5> endings{".hdr", ".pic", ".png", ".jpg", ".jpeg"};
  return endings;
}

Result<RadianceImage> read_environment(std::string_view file) {
  if (looks_like_radiance(file)) return reduced_radiance(file);
  const bool png = looks_like_png(file);
  if (!png && !looks_like_jpeg(file))
    return make_error(e_picture_kind, "The file is no Radiance, PNG or JPEG picture.",
                      "Save the panorama as .hdr, .png or .jpg and use that.");
  const auto size = reference_size(file);
  if (!size) return size.error();
  if (const auto fits = check_shape(*size); !fits) return fits.error();
  const auto image =
      png ? decode_png(file, most_environment_pixels) : read_jpeg(file, most_environment_pixels);
  if (!image) return image.error();
  return reduced_picture(*image);
}

}  // namespace hariko

// Readers of pictures: PNG, JPEG and WebP, from the outside as the window reads them, and Radiance.

#include "render/read_radiance.hpp"
#include "render/reference_image.hpp"
#include "tests/fuzz/check.hpp"

namespace hariko::fuzz {

/// Size up to which pixels are decoded: a few bytes may promise many millions, which are read, but take
/// seconds here.
constexpr std::int64_t most_fuzzed_pixels = 1'000'000;

inline bool is_small(PixelSize size) {
  require(size.width >= 1 && size.height >= 1, "there are pixels");
  return std::int64_t(size.width) * size.height <= most_fuzzed_pixels;
}

/// Checks that the decoded size is that of the header, with all smaller versions.
inline void check_reference(std::string_view file) {
  const auto size = reference_size(file);
  if (!size.ok()) return check(size.error(), Severity::error);
  if (!is_small(*size)) return;
  const auto image = decode_reference(file);
  if (!image.ok()) return check(image.error(), Severity::error);
  require(image->size == *size, "the size is that of the header");
  require(!image->levels.empty(), "there is a level");
  const Image& last = image->levels.back();
  require(last.width == 1 && last.height == 1, "the last level is one pixel");
  for (const Image& level : image->levels)
    require(level.rgba.size() == 4 * std::size_t(level.width) * std::size_t(level.height),
            "levels are whole");
}

/// Rows come in their order and are whole; light is finite and not negative.
inline void check_radiance(std::string_view file) {
  const auto size = radiance_size(file);
  if (!size.ok()) return check(size.error(), Severity::error);
  if (!is_small(*size)) return;
  int next = 0;
  const auto read = read_radiance(file, [&](int row, std::span<const Radiance> pixels) {
    require(row == next++ && pixels.size() == std::size_t(size->width), "rows are whole and in order");
    for (const Radiance& pixel : pixels)
      for (const float value : pixel) require(value >= 0 && value <= 3e38F, "light is finite");
  });
  if (!read.ok()) return check(read.error(), Severity::error);
  require(next == size->height, "all rows come");
}

}  // namespace hariko::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hariko;
  const std::string_view file(reinterpret_cast<const char*>(data), size);
  looks_like_radiance(file) ? fuzz::check_radiance(file) : fuzz::check_reference(file);
  return 0;
}

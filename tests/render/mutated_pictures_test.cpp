// Pictures that something went wrong with: each is read, or refused with a reason, in bounded time and
// memory.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/read_photo.hpp"
#include "render/read_radiance.hpp"
#include "render/reference_image.hpp"
#include "tests/support/mutated.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

namespace hariko {
namespace {

namespace fs = std::filesystem;

/// Pixels that are decoded: a changed header may promise millions, which would be read, but cost this test
/// seconds.
constexpr std::int64_t most_tried_pixels = 4'000'000;

/// The seeds of the fuzzer, by their names.
std::vector<fs::path> picture_seeds() {
  std::vector<fs::path> out;
  for (const auto& entry :
       fs::directory_iterator(fs::path(test::source_folder()) / "tests" / "fuzz" / "seeds" / "pictures"))
    out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

void expect_reason(const Message& message) {
  EXPECT_TRUE(message.code.name.starts_with("E_"));
  EXPECT_FALSE(message.text.empty());
  EXPECT_FALSE(message.remedy.empty());
}

bool expect_radiance(const std::string& file) {
  const auto size = radiance_size(file);
  if (!size.ok()) return expect_reason(size.error()), false;
  EXPECT_LE(std::uint64_t(size->width) * std::uint64_t(size->height), most_radiance_pixels);
  if (std::int64_t(size->width) * size->height > most_tried_pixels) return false;
  int rows = 0;
  bool finite = true;
  const auto read = read_radiance(file, [&](int row, std::span<const Radiance> pixels) {
    EXPECT_EQ(row, rows++);
    for (const Radiance& pixel : pixels)
      for (const float value : pixel) finite = finite && std::isfinite(value) && value >= 0;
  });
  EXPECT_TRUE(finite);
  if (!read.ok()) return expect_reason(read.error()), false;
  EXPECT_EQ(rows, size->height);
  return true;
}

bool expect_reference(const std::string& file) {
  const auto size = reference_size(file);
  if (!size.ok()) return expect_reason(size.error()), false;
  const std::int64_t pixels = std::int64_t(size->width) * size->height;
  EXPECT_LE(pixels, 100'000'000);
  if (pixels > most_tried_pixels) return false;
  const auto image = decode_reference(file);
  if (!image.ok()) return expect_reason(image.error()), false;
  EXPECT_EQ(image->size, *size);
  // Four bytes a pixel, in levels that each have at most half the pixels of the one before.
  EXPECT_LE(image->bytes(), std::size_t(8 * pixels));
  return true;
}

/// Whether bytes were read as a picture; expects a sound one, or a reason.
bool expect_picture_or_reason(const std::string& file) {
  return looks_like_radiance(file) ? expect_radiance(file) : expect_reference(file);
}

TEST(MutatedPictures, AHundredOfEachSeedAreReadOrRefusedWithAReason) {
  const std::vector<fs::path> seeds = picture_seeds();
  ASSERT_GE(seeds.size(), 10U);
  std::uint64_t seed = 8100;
  for (const fs::path& path : seeds) {
    SCOPED_TRACE(path.filename().string());
    const std::string original = test::slurp(path);
    const bool webp = path.extension() == ".webp";
    EXPECT_EQ(expect_picture_or_reason(original), path.stem() != "animation" && (!webp || reads_webp()));
    std::size_t read = 0;
    test::for_random(seed, 100, [&](std::mt19937_64& rng) {
      read += expect_picture_or_reason(test::mutated(rng, original));
    });
    std::printf("%s: %zu mutations from HARIKO_SEED=%llu on are read\n", path.filename().c_str(), read,
                static_cast<unsigned long long>(test::random_seed(seed)));
    seed += 1000;
  }
}

}  // namespace
}  // namespace hariko
